#include "report/charts/rose_diagram.hpp"

#include <algorithm>
#include <cmath>

#include "core/types.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

constexpr std::size_t kSectors = 12;                                        ///< over half a turn
constexpr double kRoseWidth = 300.0, kRoseHeight = 330.0, kRadius = 115.0;  // px
const Vec2 kCentre(150.0, 180.0);
constexpr const char* kRoseText = "font-size=\"12\" fill=\"#33404d\" text-anchor=\"middle\"";

/// @param angle  from up, to the right
Vec2 rose_point(double angle, double radius) {
  return kCentre + radius * Vec2(std::sin(angle), -std::cos(angle));
}

std::string point(const Vec2& place) {
  return format_fixed(place.x(), 1) + "," + format_fixed(place.y(), 1);
}

std::string circle(double radius, const std::string& style) {
  return "<circle cx=\"" + format_fixed(kCentre.x(), 1) + "\" cy=\"" +
         format_fixed(kCentre.y(), 1) + "\" r=\"" + format_fixed(radius, 1) + "\" fill=\"none\" " +
         style + "/>\n";
}

std::string sector(double from, double to, double radius, const std::string& colour,
                   const std::string& note) {
  return "<path d=\"M" + point(kCentre) + " L" + point(rose_point(from, radius)) + " A" +
         format_fixed(radius, 1) + "," + format_fixed(radius, 1) + " 0 0 1 " +
         point(rose_point(to, radius)) + " Z\" fill=\"" + colour +
         "\" fill-opacity=\".55\" stroke=\"" + colour + "\"><title>" + escape_html(note) +
         "</title></path>\n";
}

/// Axes of each sector of half a turn, from -90 degrees on.
std::vector<std::size_t> sector_counts(const std::vector<double>& trends) {
  std::vector<std::size_t> counts(kSectors, 0);
  const double width = kPi / static_cast<double>(kSectors);
  for (const double trend : trends) {
    // Sectors begin half of their width before -90 degrees, so that one is along downslope.
    const double turned = wrap_axial_angle(trend) + 0.5 * kPi + 0.5 * width;
    ++counts[static_cast<std::size_t>(turned / width) % kSectors];
  }
  return counts;
}

}  // namespace

std::string draw_rose_diagram(const std::string& name, const std::string& colour,
                              const std::vector<double>& trends, const AxialMean& mean,
                              const RoseDirections& directions) {
  const std::vector<std::size_t> counts = sector_counts(trends);
  const std::size_t maximum =
      std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  const auto radius_of = [&](double count) {
    return kRadius * std::sqrt(count / static_cast<double>(maximum));
  };
  std::string svg = open_svg(kRoseWidth, kRoseHeight, "Directions of long axes: " + name);
  svg += svg_text(kCentre.x(), 18.0, shorten_text(name, 40),
                  "font-size=\"13\" font-weight=\"700\" fill=\"#1d2733\" text-anchor=\"middle\"");
  svg += circle(kRadius, "stroke=\"#8a94a0\"");
  // Radius of all sectors for uniform directions.
  const double even = static_cast<double>(trends.size()) / static_cast<double>(kSectors);
  if (even <= static_cast<double>(maximum)) {
    svg += circle(radius_of(even), "stroke=\"#5b6775\" stroke-dasharray=\"3 3\"");
  }
  const double width = kPi / static_cast<double>(kSectors);
  for (std::size_t i = 0; i < kSectors; ++i) {
    if (counts[i] == 0) continue;
    const double middle = width * static_cast<double>(i) - 0.5 * kPi;
    const std::string note =
        format_fixed(middle * 180.0 / kPi, 0) + "\xC2\xB0: " + format_count(counts[i], "block") +
        ", " + format_percent(static_cast<double>(counts[i]) / static_cast<double>(trends.size()));
    for (const double turn : {0.0, kPi}) {
      svg += sector(middle - 0.5 * width + turn, middle + 0.5 * width + turn,
                    radius_of(static_cast<double>(counts[i])), colour, note);
    }
  }
  if (std::isfinite(mean.direction)) {
    const Vec2 a = rose_point(mean.direction, kRadius * mean.resultant_length);
    const Vec2 b = rose_point(mean.direction + kPi, kRadius * mean.resultant_length);
    svg += format_svg_line(a.x(), a.y(), b.x(), b.y(), "stroke=\"#1d2733\" stroke-width=\"3\"");
  }
  svg += svg_text(kCentre.x(), kCentre.y() - kRadius - 8.0, directions.top, kRoseText);
  svg += svg_text(kCentre.x(), kCentre.y() + kRadius + 16.0, directions.bottom, kRoseText);
  return svg + "</svg>\n";
}

}  // namespace clast::report_detail
