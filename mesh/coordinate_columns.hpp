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
  std::vector<LengthUnitDeclaration> lengths = {};
};

/// Parses a coordinate heading such as "x", "Easting", "Rechtswert", "Points:0" or "Quota (m)" in
/// English, German, French, Italian or Spanish; returns 0, 1 or 2 for x, y or z, or nothing for
/// other names.
std::optional<int> parse_coordinate_axis(std::string_view heading);

/// Finds the columns of x, y and z by their headings: all three letters, otherwise one name each
/// for easting, northing and height.
/// @param headings  without quotes
/// @return empty unless each axis is named once
/// @throws InputError  if the headings name longitude and latitude in degrees; without the file
///                     name
std::optional<CoordinateColumns> find_coordinate_columns(
    const std::vector<std::string_view>& headings);

/// Selects columns by name or 1-based number, in the order x, y, z.
/// @param headings  empty if the table has none
/// @throws InputError  if there are not three different existing columns; without the file name
CoordinateColumns select_coordinate_columns(const std::vector<std::string>& columns,
                                            const std::vector<std::string_view>& headings,
                                            std::size_t fields);

}  // namespace clast
