#pragma once
/// Numbers in and out as text, the same whatever the locale.
#include <optional>
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace clast {

/// The number that is all of `text`; none when anything else is in it, spaces included, or when a
/// double can't hold it. One leading "+" is allowed; "nan" and "inf" are numbers here.
std::optional<double> parse_number(std::string_view text);

/// `value` with so many significant digits and no zeros at the end, as for messages: "0.0254".
std::string format_significant(double value, int digits);

/// `value` with so many significant digits, zeros at the end kept; with an exponent only from 1e7
/// and below 1e-4.
std::string format_rounded(double value, int digits = 4);
/// With so many digits after the point; never "-0.0".
std::string format_decimals(double value, int decimals);
/// 0.0312 to "3.1 %".
std::string format_percent(double fraction, int decimals = 1);

/// "1 point", "2 points".
std::string format_count(std::size_t count, const std::string& noun);
/// The same of a noun whose plural is not its singular with an "s".
std::string format_count(std::size_t count, const std::string& singular, const std::string& plural);

/// "(x, y, z), nine significant digits each: to the centimetre on a map, which is enough to find
/// the place in a viewer.
std::string format_point(const Vec3& point);
/// "x 652013.250, y 5203000.000, z 1824.310": to the millimetre, in map coordinates.
std::string format_map_point(const Vec3& point);

}  // namespace clast
