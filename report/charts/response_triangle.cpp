#include "report/charts/response_triangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/png.hpp"
#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

constexpr double kWidth = 620.0, kHeight = 560.0, kLeft = 50.0, kTop = 40.0, kSide = 520.0;  // px
constexpr double kLargestDisc = 20.0, kSmallestDisc = 5.0;
/// Values are written into discs of this radius and larger.
constexpr double kReadableDisc = 13.0;

/// Few to many, readable in grey: pale yellow over green to dark blue (YlGnBu of ColorBrewer).
constexpr std::array<Rgb, 5> kColours = {
    {{255, 255, 204}, {161, 218, 180}, {65, 182, 196}, {44, 127, 184}, {37, 52, 148}}};

Rgb colour_of(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (kColours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kColours.size() - 2);
  Rgb colour{};
  for (std::size_t k = 0; k < colour.size(); ++k) {
    colour[k] = static_cast<std::uint8_t>(std::lround(std::lerp<double, double, double>(
        kColours[below][k], kColours[below + 1][k], place - static_cast<double>(below))));
  }
  return colour;
}

/// Of a part of the triangle.
Vec2 place_of(double compact, double elongate) {
  const double height = kSide * std::sqrt(0.75);
  return {kLeft + kSide * (elongate + 0.5 * compact), kTop + height * (1.0 - compact)};
}

std::string frame() {
  const Vec2 top = place_of(1.0, 0.0), platy = place_of(0.0, 0.0), elongate = place_of(0.0, 1.0);
  const std::string style = "stroke=\"#8a94a0\"";
  std::string svg = svg_line(top.x(), top.y(), platy.x(), platy.y(), style) +
                    svg_line(platy.x(), platy.y(), elongate.x(), elongate.y(), style) +
                    svg_line(elongate.x(), elongate.y(), top.x(), top.y(), style);
  // Limits of the classes: S/L = 0.3, 0.5, 0.7, and (L - I)/(L - S) = 0.33, 0.67 below 0.7.
  const std::string limit = "stroke=\"#d3d9df\"";
  for (const double q : {0.3, 0.5, 0.7}) {
    const Vec2 a = place_of(q, 0.0), b = place_of(q, 1.0 - q);
    svg += svg_line(a.x(), a.y(), b.x(), b.y(), limit);
  }
  for (const double d : {0.33, 0.67}) {
    const Vec2 a = place_of(0.0, d), b = place_of(0.7, 0.3 * d);
    svg += svg_line(a.x(), a.y(), b.x(), b.y(), limit);
  }
  return svg + svg_text(top.x(), top.y() - 26.0, "compact", "text-anchor=\"middle\"") +
         svg_text(platy.x(), platy.y() + 34.0, "platy", "text-anchor=\"middle\"") +
         svg_text(elongate.x(), elongate.y() + 34.0, "elongate", "text-anchor=\"middle\"");
}

/// Discs that do not cover each other, where that can be had.
double disc_radius(std::span<const Vec2> places) {
  double nearest = 2.0 * kLargestDisc;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      nearest = std::min(nearest, (places[i] - places[k]).norm());
    }
  }
  return std::max(kSmallestDisc, 0.48 * nearest);
}

}  // namespace

std::string response_triangle(std::span<const FormResponse> forms, const std::string& label) {
  std::vector<Vec2> places;
  double least = 1e300, most = -1e300;
  for (const FormResponse& form : forms) {
    const TernaryPlace place = ternary_place(form.axes);
    places.push_back(place_of(place.compact, place.elongate));
    least = std::min(least, form.value);
    most = std::max(most, form.value);
  }
  const double radius = disc_radius(places);
  std::string svg = svg_open(kWidth, kHeight, label + " over the triangle of Sneed and Folk");
  svg += frame();
  for (std::size_t i = 0; i < forms.size(); ++i) {
    const double share = most > least ? (forms[i].value - least) / (most - least) : 0.0;
    svg += "<circle cx=\"" + fixed(places[i].x(), 1) + "\" cy=\"" + fixed(places[i].y(), 1) +
           "\" r=\"" + fixed(radius, 1) + "\" fill=\"" + colour_text(colour_of(share)) +
           "\" stroke=\"#5b6670\"><title>" +
           escaped(forms[i].name + ": " + significant(forms[i].value) + ", " + label) +
           "</title></circle>";
    if (radius < kReadableDisc) continue;
    svg += svg_text(places[i].x(), places[i].y() + 4.0, significant(forms[i].value, 2),
                    std::string("text-anchor=\"middle\" font-size=\"12\" fill=\"") +
                        (share > 0.5 ? "#ffffff" : "#1d2733") + "\" pointer-events=\"none\"");
  }
  return svg + "</svg>\n";
}

}  // namespace clast::report_detail
