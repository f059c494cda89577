#pragma once
/// Locale-independent parsing and formatting of numbers.
#include <optional>
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace clast {

/// Parses a text that is exactly one number, without spaces. A leading "+", "nan" and "inf" are
/// accepted. Empty if the text is not a number or is out of the range of a double.
std::optional<double> parse_number(std::string_view text);

/// Formats a number with significant digits and without trailing zeros: "0.0254".
std::string format_significant(double value, int digits);

/// Formats significant digits with trailing zeros. Uses an exponent below 1e-4 and from 1e7.
std::string format_rounded(double value, int digits = 4);
/// Formats a number with fixed decimals; never "-0.0".
std::string format_decimals(double value, int decimals);
/// Formats a fraction in per cent: 0.0312 as "3.1 %".
std::string format_percent(double fraction, int decimals = 1);

/// Formats a count with its noun: "1 point", "2 points".
std::string format_count(std::size_t count, const std::string& noun);
/// Formats a count of a noun with an irregular plural.
std::string format_count(std::size_t count, const std::string& singular, const std::string& plural);

/// Formats a point as "(x, y, z)" with nine significant digits, a centimetre in map coordinates.
std::string format_point(const Vec3& point);
/// Formats a point in map coordinates to the millimetre: "x 652013.250, y 5203000.000, z 1824.310".
std::string format_map_point(const Vec3& point);

}  // namespace clast
