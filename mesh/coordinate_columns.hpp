#pragma once
/// Columns of coordinates in tables and text clouds.
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/reference_system.hpp"

namespace clast {

/// Columns of x, y and z, and what their headings say of the units.
struct CoordinateColumns {
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::vector<LengthUnitDeclaration> lengths = {};
};

/// Names that stand for x, y or z: "x", "Easting", "Rechtswert", "Points:0", "Quota (m)" and others
/// alike, in English, German, French, Italian and Spanish; 0, 1 or 2. None: another name.
std::optional<int> parse_coordinate_axis(std::string_view heading);

/// Finds the columns of x, y and z by their headings: all three letters, else one name for each of
/// easting, northing and height.
/// @param headings  without their quotes
/// @return none where the headings do not name each axis once
/// @throws InputError  they name degrees of longitude and latitude; the message has no file name
std::optional<CoordinateColumns> find_coordinate_columns(
    const std::vector<std::string_view>& headings);

/// Columns by name or by number from 1, in the order x, y, z.
/// @param headings  empty: the table has none
/// @throws InputError  not three, twice the same, or no such column; no file name
CoordinateColumns select_coordinate_columns(const std::vector<std::string>& columns,
                                            const std::vector<std::string_view>& headings,
                                            std::size_t fields);

}  // namespace clast
