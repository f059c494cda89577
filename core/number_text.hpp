#pragma once
/// Numbers in and out as text, the same whatever the locale.
#include <optional>
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace clast {

/// The number that is all of `text`; none when anything else is in it, spaces included, or when a
/// double can't hold it. One leading "+" is allowed; "nan" and "inf" are numbers here.
std::optional<double> number_in(std::string_view text);

/// `value` with so many significant digits and no zeros at the end, as for messages: "0.0254".
std::string with_digits(double value, int digits);

/// `value` with so many significant digits, without an exponent where it stays readable.
std::string rounded(double value, int digits = 4);
/// With so many digits after the point.
std::string with_decimals(double value, int decimals);

/// "1 point", "2 points".
std::string counted(std::size_t count, const std::string& noun);
/// The same of a noun whose plural is not its singular with an "s".
std::string counted(std::size_t count, const std::string& singular, const std::string& plural);

/// "(x, y, z), nine significant digits each: to the centimetre on a map, which is enough to find
/// the place in a viewer.
std::string place(const Vec3& point);

}  // namespace clast
