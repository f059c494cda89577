#pragma once
/// Colours of the report, which colour-blind readers can distinguish. Marker shapes and dashes are
/// used for greyscale print.
#include <array>
#include <cstddef>
#include <string>

#include "core/files/png.hpp"

namespace clast::report_detail {

/// Colours of data series (Okabe & Ito without yellow, which is too pale on white).
/// @cite okabe2008
inline constexpr std::array<const char*, 6> kDataColours = {"#0072B2", "#D55E00", "#009E73",
                                                            "#CC79A7", "#E69F00", "#56B4E9"};
inline constexpr std::array<const char*, 4> kDashes = {"", "6 3", "2 2", "8 3 2 3"};

/// Returns the colour of the n-th curve; colours repeat after six.
inline std::string series_colour(std::size_t n) { return kDataColours[n % kDataColours.size()]; }

/// Formats a colour as "#0072b2".
inline std::string format_colour(const Rgb& colour) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : colour) text += {kDigits[part >> 4], kDigits[part & 15]};
  return text;
}

/// Mixes a colour with the fraction `share` of another colour.
inline std::string mix_colours(const std::string& colour, const std::string& other, double share) {
  Rgb parts{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto part = [&](const std::string& text) {
      return static_cast<double>(std::stoi(text.substr(1 + 2 * i, 2), nullptr, 16));
    };
    parts[i] = static_cast<std::uint8_t>((1.0 - share) * part(colour) + share * part(other) + 0.5);
  }
  return format_colour(parts);
}

/// Returns the colour of a Garcia class, which is the same in all reports.
inline std::string class_colour(const std::string& garcia) {
  if (garcia == "compact") return kDataColours[0];
  if (garcia == "elongated") return kDataColours[1];
  return "#555555";
}

}  // namespace clast::report_detail
