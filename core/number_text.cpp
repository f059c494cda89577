#include "core/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace clast {

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::string with_digits(double value, int digits) {
  // Sign, point, "0.000" and exponent beside the digits; a double has no more than 767 of them.
  std::array<char, 800> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

std::string rounded(double value, int digits) {
  char text[64];
  const double size = std::abs(value);
  if (size != 0.0 && (size < 1e-4 || size >= 1e7)) {
    std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
    return text;
  }
  const int before = size > 0.0 ? static_cast<int>(std::floor(std::log10(size))) + 1 : 1;
  return with_decimals(value, std::max(0, digits - before));
}

std::string with_decimals(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string counted(std::size_t count, const std::string& noun) {
  return counted(count, noun, noun + "s");
}

std::string counted(std::size_t count, const std::string& singular, const std::string& plural) {
  return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

std::string place(const Vec3& point) {
  const auto text = [](double value) { return with_digits(value, 9); };
  return "(" + text(point.x()) + ", " + text(point.y()) + ", " + text(point.z()) + ")";
}

}  // namespace clast
