#include "report/charts/response_triangle.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <vector>

#include "core/files/png.hpp"
#include "core/nice_number.hpp"
#include "report/charts/contour_field.hpp"
#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

constexpr double kResponseWidth = 700.0, kResponseHeight = 560.0, kResponseLeft = 50.0,
                 kResponseTop = 40.0, kResponseSide = 520.0;  // px
constexpr double kDisc = 3.5, kMarkedDisc = 6.0;
constexpr double kLattice = 7.0;  ///< side of the triangles of the surface
constexpr int kMinBands = 6;
constexpr std::size_t kMaxForms = 500;  ///< of a surface: its equations are that many

/// Few to many, readable in grey: pale yellow over green to dark blue (YlGnBu of ColorBrewer).
constexpr std::array<Rgb, 5> kColours = {
    {{255, 255, 204}, {161, 218, 180}, {65, 182, 196}, {44, 127, 184}, {37, 52, 148}}};

Rgb response_colour(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (kColours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kColours.size() - 2);
  Rgb colour{};
  for (std::size_t k = 0; k < colour.size(); ++k) {
    colour[k] = static_cast<std::uint8_t>(std::lround(std::lerp<double, double, double>(
        kColours[below][k], kColours[below + 1][k], place - static_cast<double>(below))));
  }
  return colour;
}

/// Position in the image of a point of the triangle.
Vec2 triangle_point(double compact, double elongate) {
  const double height = kResponseSide * std::sqrt(0.75);
  return {kResponseLeft + kResponseSide * (elongate + 0.5 * compact),
          kResponseTop + height * (1.0 - compact)};
}

std::string triangle_frame() {
  const Vec2 top = triangle_point(1.0, 0.0), platy = triangle_point(0.0, 0.0),
             elongate = triangle_point(0.0, 1.0);
  const std::string style = "stroke=\"#8a94a0\"";
  std::string svg = format_svg_line(top.x(), top.y(), platy.x(), platy.y(), style) +
                    format_svg_line(platy.x(), platy.y(), elongate.x(), elongate.y(), style) +
                    format_svg_line(elongate.x(), elongate.y(), top.x(), top.y(), style);
  // Limits of the classes: S/L = 0.3, 0.5, 0.7, and (L - I)/(L - S) = 0.33, 0.67 below 0.7.
  const std::string limit = "stroke=\"#d3d9df\"";
  for (const double q : {0.3, 0.5, 0.7}) {
    const Vec2 a = triangle_point(q, 0.0), b = triangle_point(q, 1.0 - q);
    svg += format_svg_line(a.x(), a.y(), b.x(), b.y(), limit);
  }
  for (const double d : {0.33, 0.67}) {
    const Vec2 a = triangle_point(0.0, d), b = triangle_point(0.7, 0.3 * d);
    svg += format_svg_line(a.x(), a.y(), b.x(), b.y(), limit);
  }
  return svg + svg_text(top.x(), top.y() - 26.0, "compact", "text-anchor=\"middle\"") +
         svg_text(platy.x(), platy.y() + 34.0, "platy", "text-anchor=\"middle\"") +
         svg_text(elongate.x(), elongate.y() + 34.0, "elongate", "text-anchor=\"middle\"");
}

/// Values and colours of the picture.
struct ResponseRange {
  double minimum = 1e300, maximum = -1e300;
  double step = 1.0;  ///< between contour lines

  double share(double value) const {
    return maximum > minimum ? (value - minimum) / (maximum - minimum) : 0.0;
  }
  /// Round values between the least and the largest.
  std::vector<double> levels() const {
    std::vector<double> levels;
    if (!(maximum > minimum)) return levels;
    for (double k = std::floor(minimum / step) + 1.0; k * step < maximum; k += 1.0) {
      levels.push_back(k * step);
    }
    return levels;
  }
  /// Colour of the band from this level to the next.
  std::string colour(double level) const {
    return format_colour(response_colour(share(std::min(maximum, level + 0.5 * step))));
  }
};

ResponseRange response_range(std::span<const ShapeResponse> forms) {
  ResponseRange range;
  for (const ShapeResponse& form : forms) {
    range.minimum = std::min(range.minimum, form.value);
    range.maximum = std::max(range.maximum, form.value);
  }
  if (range.maximum > range.minimum) {
    range.step = round_down_to_nice_number((range.maximum - range.minimum) / kMinBands);
  }
  return range;
}

/// Positions of contour labels, which do not overlap.
class LabelPlaces {
 public:
  /// @param hull  that cuts off what lies outside
  explicit LabelPlaces(std::span<const Vec2> hull) {
    for (const Vec2& corner : hull) bottom_ = std::max(bottom_, corner.y());
  }
  /// The place farthest right on the line that is free; it is taken then.
  std::optional<Vec2> take(const ContourLine& line) {
    std::optional<Vec2> best;
    for (const auto& [place, end] : line.pieces) {
      if ((!best || place.x() > best->x()) && free(place)) best = place;
    }
    if (best) taken_.push_back(*best);
    return best;
  }

 private:
  bool free(const Vec2& place) const {
    constexpr double kWide = 32.0, kHigh = 14.0;
    return place.y() < bottom_ - 0.5 * kHigh &&
           std::none_of(taken_.begin(), taken_.end(), [&](const Vec2& other) {
             return std::abs(other.x() - place.x()) < kWide &&
                    std::abs(other.y() - place.y()) < kHigh;
           });
  }

  std::vector<Vec2> taken_;
  double bottom_ = 0.0;
};

/// Contour line with its value, where there is a place for it.
std::string line_of(const ThinPlateSpline& surface, std::span<const Vec2> hull, double level,
                    LabelPlaces& places) {
  const ContourLine line = trace_contour_line(surface, hull, level, kLattice);
  if (line.pieces.empty()) return "";
  const std::string svg =
      "<path d=\"" + line.path + "\" fill=\"none\" stroke=\"#1d2733\" stroke-width=\"0.8\"/>";
  const std::optional<Vec2> place = places.take(line);
  if (!place) return svg;
  return svg + svg_text(place->x() - 4.0, place->y() + 4.0, format_significant_digits(level, 3),
                        "text-anchor=\"end\" font-size=\"11\" fill=\"#1d2733\" stroke=\"#ffffff\" "
                        "stroke-width=\"2.5\" paint-order=\"stroke\"");
}

/// Bands, each over those below it, and lines, within the forms.
std::string surface_of(std::span<const ShapeResponse> forms, std::span<const Vec2> places,
                       const ResponseRange& range, const std::string& clip) {
  const std::vector<Vec2> hull = plan_convex_hull(places);
  if (hull.size() < 3 || forms.size() > kMaxForms || !(range.maximum > range.minimum)) return "";
  std::vector<double> values;
  for (const ShapeResponse& form : forms) values.push_back(form.value);
  const ThinPlateSpline surface(places, values);
  std::string outline;
  for (const Vec2& corner : hull) {
    outline += (outline.empty() ? "" : " ") + format_fixed(corner.x(), 1) + "," +
               format_fixed(corner.y(), 1);
  }
  const std::vector<double> levels = range.levels();
  std::string svg = "<clipPath id=\"" + clip + "\"><polygon points=\"" + outline +
                    "\"/></clipPath><g clip-path=\"url(#" + clip + ")\"><polygon points=\"" +
                    outline + "\" fill=\"" + range.colour(range.minimum - 0.5 * range.step) +
                    "\"/>";
  for (const double level : levels) {
    svg += "<path d=\"" + format_band_path(surface, hull, level, kLattice) + "\" fill=\"" +
           range.colour(level) + "\"/>";
  }
  LabelPlaces labels(hull);
  for (const double level : levels) svg += line_of(surface, hull, level, labels);
  return svg + "</g>";
}

/// Draws the label, and below it the colours of the bands with the values between them.
std::string legend(const ResponseRange& range, const std::string& label) {
  const std::vector<double> levels = range.levels();
  constexpr double kX = 590.0, kBottom = 270.0, kBox = 18.0;
  double y = kBottom;
  const double top = std::min(60.0, y - kBox * static_cast<double>(levels.size()) - 12.0);
  std::string svg = svg_text(570.0, top, label, "text-anchor=\"middle\" font-size=\"13\"");
  if (levels.empty()) return svg;
  for (std::size_t i = 0; i <= levels.size(); ++i, y -= kBox) {
    const double from = i == 0 ? range.minimum - 0.5 * range.step : levels[i - 1];
    svg += "<rect x=\"" + format_fixed(kX, 1) + "\" y=\"" + format_fixed(y, 1) + "\" width=\"" +
           format_fixed(kBox, 1) + "\" height=\"" + format_fixed(kBox, 1) + "\" fill=\"" +
           range.colour(from) + "\" stroke=\"#8a94a0\" stroke-width=\"0.5\"/>";
    if (i < levels.size()) {
      svg += svg_text(kX + kBox + 6.0, y + 4.0, format_significant_digits(levels[i], 3),
                      "font-size=\"12\"");
    }
  }
  return svg;
}

std::string disc_of(const ShapeResponse& form, const Vec2& place, const ResponseRange& range,
                    const std::string& label) {
  std::string svg =
      "<circle cx=\"" + format_fixed(place.x(), 1) + "\" cy=\"" + format_fixed(place.y(), 1) +
      "\" r=\"" + format_fixed(form.marked ? kMarkedDisc : kDisc, 1) + "\" fill=\"" +
      format_colour(response_colour(range.share(form.value))) + "\" stroke=\"" +
      (form.marked ? "#d55e00\" stroke-width=\"2" : "#5b6670") + "\"><title>" +
      escape_html(form.name + ": " + format_significant_digits(form.value) + ", " + label) +
      "</title></circle>";
  if (form.marked) {
    svg += svg_text(place.x() + 9.0, place.y() + 4.0, form.name,
                    "font-size=\"11\" stroke=\"#ffffff\" stroke-width=\"2.5\" "
                    "paint-order=\"stroke\"");
  }
  return svg;
}

}  // namespace

std::string draw_response_triangle(std::span<const ShapeResponse> forms, const std::string& label) {
  std::vector<Vec2> places;
  for (const ShapeResponse& form : forms) {
    const TernaryCoordinates place = ternary_coordinates(form.axes);
    places.push_back(triangle_point(place.compact, place.elongate));
  }
  const ResponseRange range = response_range(forms);
  // Several pictures of a page must not share a clip.
  std::string clip = "clip";
  for (const char c : label) clip += std::isalnum(static_cast<unsigned char>(c)) ? c : '-';
  std::string svg =
      open_svg(kResponseWidth, kResponseHeight, label + " over the triangle of Sneed and Folk");
  svg += surface_of(forms, places, range, clip) + triangle_frame() + legend(range, label);
  for (const bool marked : {false, true}) {
    for (std::size_t i = 0; i < forms.size(); ++i) {
      if (forms[i].marked == marked) svg += disc_of(forms[i], places[i], range, label);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace clast::report_detail
