#pragma once
/// Colours of the report: distinct to colour-blind readers too, and in grey by marker and dash.
#include <array>
#include <cstddef>
#include <string>

#include "core/png.hpp"

namespace clast::report_detail {

/// Strong colours of Okabe & Ito for data, without yellow, which vanishes on white.
/// @cite okabe2008
inline constexpr std::array<const char*, 6> kDataColours = {"#0072B2", "#D55E00", "#009E73",
                                                            "#CC79A7", "#E69F00", "#56B4E9"};
inline constexpr std::array<const char*, 4> kDashes = {"", "6 3", "2 2", "8 3 2 3"};

/// Colour and line of the n-th curve; together they repeat after 24.
inline std::string data_colour(std::size_t n) { return kDataColours[n % kDataColours.size()]; }
inline std::string data_dash(std::size_t n) {
  return kDashes[n / kDataColours.size() % kDashes.size()];
}

/// "#0072b2", as HTML, plotly.js and QGIS read it.
inline std::string colour_text(const Rgb& colour) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : colour) text += {kDigits[part >> 4], kDigits[part & 15]};
  return text;
}

/// Compact and elongated keep their colours in every report.
inline std::string class_colour(const std::string& garcia) {
  if (garcia == "compact") return kDataColours[0];
  if (garcia == "elongated") return kDataColours[1];
  return "#555555";
}

}  // namespace clast::report_detail
