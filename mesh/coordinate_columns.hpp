#pragma once
/// Coordinate columns of tables and text point clouds.
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/reference_system.hpp"

namespace clast {

/// Indices of the columns of x, y and z, with the units declared by their headings.
struct CoordinateColumns {
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::vector<LengthUnitDeclaration> unit_declarations = {};
};

/// Parses a coordinate heading in English, German, French, Italian or Spanish, such as "x",
/// "Easting", "Rechtswert", "Points:0" or "Quota (m)". Returns 0, 1, 2 for x, y, z; else empty.
std::optional<int> parse_coordinate_axis(std::string_view heading);

/// Finds the columns of x, y and z by their headings: the three letters, or otherwise one name each
/// for easting, northing and height.
/// @param headings  headings without quotes
/// @return columns; empty unless exactly one heading names each axis
/// @throws InputError  if the headings name longitude and latitude in degrees; the message does not
///                     name the file
std::optional<CoordinateColumns> find_coordinate_columns(
    const std::vector<std::string_view>& headings);

/// Selects the columns of x, y and z by name or by number, counted from 1.
/// @param headings  headings of the table; empty if it has none
/// @throws InputError  if there are not three different columns; the message does not name the file
CoordinateColumns select_coordinate_columns(const std::vector<std::string>& columns,
                                            const std::vector<std::string_view>& headings,
                                            std::size_t fields);

}  // namespace clast
