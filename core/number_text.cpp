#include "core/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace clast {

namespace {

std::string in_format(double value, std::chars_format format, int precision) {
  // Sign, point, "0.000" and exponent beside the digits; a double has no more than 767 of them.
  std::array<char, 1200> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format, precision);
  return {text.data(), end.ptr};
}

/// Non-finite numbers as written by Microsoft's C library: "-1.#IND", "1.#INF00".
std::optional<double> not_finite_in(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  if (!text.starts_with("1.#")) return std::nullopt;
  text.remove_prefix(3);
  while (text.ends_with('0')) text.remove_suffix(1);
  if (text == "INF") {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return negative ? -kInfinity : kInfinity;
  }
  if (text != "IND" && text != "QNAN" && text != "SNAN" && text != "R") return std::nullopt;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return not_finite_in(text);
  return value;
}

std::string format_significant(double value, int digits) {
  return in_format(value, std::chars_format::general, digits);
}

std::string format_rounded(double value, int digits) {
  if (value == 0.0 || !std::isfinite(value)) return format_significant(value, digits);
  const std::string scientific = in_format(value, std::chars_format::scientific, digits - 1);
  // Read from the rounded number: 9.996 has two digits before the point once it is 10.0.
  const int exponent = std::atoi(scientific.c_str() + scientific.find('e') + 1);
  if (exponent >= 7 || exponent < -4) return scientific;
  return format_decimals(value, std::max(0, digits - 1 - exponent));
}

std::string format_decimals(double value, int decimals) {
  std::string text = in_format(value, std::chars_format::fixed, decimals);
  // "-0.0" is a rounding residue, not a sign anyone asked for.
  if (text.front() == '-' && text.find_first_not_of("-0.") == text.npos) text.erase(0, 1);
  return text;
}

std::string format_percent(double fraction, int decimals) {
  return format_decimals(100.0 * fraction, decimals) + " %";
}

std::string format_count(std::size_t count, const std::string& noun) {
  return format_count(count, noun, noun + "s");
}

std::string format_count(std::size_t count, const std::string& singular,
                         const std::string& plural) {
  return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

std::string format_point(const Vec3& point) {
  const auto text = [](double value) { return format_significant(value, 9); };
  return "(" + text(point.x()) + ", " + text(point.y()) + ", " + text(point.z()) + ")";
}

std::string format_map_point(const Vec3& point) {
  return "x " + format_decimals(point.x(), 3) + ", y " + format_decimals(point.y(), 3) + ", z " +
         format_decimals(point.z(), 3);
}

}  // namespace clast
