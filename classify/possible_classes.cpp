#include "classify/possible_classes.hpp"

#include <algorithm>
#include <cmath>

namespace clast {
namespace {

// An axis is never assumed thinner than this share of itself, however large the error.
constexpr double kThinnest = 1e-6;

using Ratios = Vec2;  // I/L, S/L

/// Corners of a convex polygon, in order; two or one where it has no area.
using Polygon = std::vector<Ratios>;

double side_of(const ClassBoundary& line, const Ratios& at) {
  return line.constant + line.i_l * at.x() + line.s_l * at.y() + line.i_l_squared * at.x() * at.x();
}

/// The part of a polygon where the line is zero or positive.
Polygon part_above(const Polygon& polygon, const ClassBoundary& line) {
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Ratios& from = polygon[i];
    const Ratios& to = polygon[(i + 1) % polygon.size()];
    const double a = side_of(line, from), b = side_of(line, to);
    if (a >= 0.0) part.push_back(from);
    if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) {
      part.emplace_back(from + a / (a - b) * (to - from));
    }
  }
  return part;
}

ClassBoundary turned(const ClassBoundary& line) {
  return {-line.constant, -line.i_l, -line.s_l, -line.i_l_squared};
}

/// L, I and S run through their ranges independently. One L fits given ratios x = I/L and y = S/L
/// if the ranges of L, I/x and S/y have a length in common, and they do if any two of them have:
/// six inequalities that are linear in x and y, beside y <= x <= 1.
Polygon reachable_ratios(const Axes& lower, const Axes& upper) {
  // Lengths are divided by L, so that rounding is independent of size.
  const double size = 0.5 * (lower.L + upper.L);
  const auto low = [&](double Axes::*axis) { return lower.*axis / size; };
  const auto high = [&](double Axes::*axis) { return upper.*axis / size; };
  Polygon polygon = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}};
  for (const ClassBoundary& line :
       {ClassBoundary{.constant = -low(&Axes::I), .i_l = high(&Axes::L)},
        ClassBoundary{.constant = high(&Axes::I), .i_l = -low(&Axes::L)},
        ClassBoundary{.constant = -low(&Axes::S), .s_l = high(&Axes::L)},
        ClassBoundary{.constant = high(&Axes::S), .s_l = -low(&Axes::L)},
        ClassBoundary{.i_l = -low(&Axes::S), .s_l = high(&Axes::I)},
        ClassBoundary{.i_l = high(&Axes::S), .s_l = -low(&Axes::I)}}) {
    polygon = part_above(polygon, line);
  }
  return polygon;
}

/// Adds the points of a polygon's edge where the class may change: its end, its middle, and for a
/// curved limit the nearest point and the crossings.
void add_edge(const Ratios& from, const Ratios& to, const std::vector<ClassBoundary>& limits,
              std::vector<Ratios>& places) {
  places.push_back(to);
  places.emplace_back(0.5 * (from + to));
  for (const ClassBoundary& limit : limits) {
    if (limit.i_l_squared == 0.0) continue;
    // The limit along the edge is c + b t + a t^2; roots without loss of digits, also for a = 0.
    const double width = to.x() - from.x();
    const double a = limit.i_l_squared * width * width, c = side_of(limit, from);
    const double b = side_of(limit, to) - c - a;
    const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(0.0, b * b - 4.0 * a * c)), b));
    for (const double share : {-0.5 * b / a, q / a, c / q}) {
      if (share > 0.0 && share < 1.0) places.emplace_back(from + share * (to - from));
    }
  }
}

/// Points in every part that the limits cut the polygon into: inside it, on each of its edges and
/// at each of its corners, for a class may hold no more than a limit.
std::vector<Ratios> places_of_all_pieces(const Polygon& polygon,
                                         const std::vector<ClassBoundary>& limits) {
  std::vector<Polygon> pieces = {polygon};
  for (const ClassBoundary& limit : limits) {
    if (limit.i_l_squared != 0.0) continue;
    std::vector<Polygon> parts;
    for (const Polygon& piece : pieces) {
      for (const ClassBoundary& side : {limit, turned(limit)}) {
        Polygon part = part_above(piece, side);
        if (!part.empty()) parts.push_back(std::move(part));
      }
    }
    pieces = std::move(parts);
  }
  std::vector<Ratios> places;
  for (const Polygon& piece : pieces) {
    Ratios sum = Ratios::Zero();
    for (std::size_t i = 0; i < piece.size(); ++i) {
      sum += piece[i];
      add_edge(piece[i], piece[(i + 1) % piece.size()], limits, places);
    }
    places.emplace_back(sum / static_cast<double>(piece.size()));
  }
  return places;
}

}  // namespace

std::vector<std::string> find_possible_classes(const std::string& scheme, const Axes& axes,
                                               double axis_error, const SchemeOptions& options) {
  const auto thinner = [&](double axis) { return std::max(axis - axis_error, kThinnest * axis); };
  return find_possible_classes(scheme, Axes{thinner(axes.L), thinner(axes.I), thinner(axes.S)},
                               Axes{axes.L + axis_error, axes.I + axis_error, axes.S + axis_error},
                               options);
}

std::vector<std::string> find_possible_classes(const std::string& scheme, const Axes& lower,
                                               const Axes& upper, const SchemeOptions& options) {
  std::vector<Ratios> places =
      places_of_all_pieces(reachable_ratios(lower, upper), class_boundaries(scheme, options));
  // A very narrow range may leave nothing of the polygon after rounding.
  const double size = lower.L + upper.L;
  places.emplace_back((lower.I + upper.I) / size, (lower.S + upper.S) / size);
  std::vector<std::string> found;
  for (const Ratios& place : places) {
    const double x = std::min(place.x(), 1.0), y = std::min(place.y(), x);
    std::string name = shape_class(scheme, {1.0, x, y}, options);
    if (std::find(found.begin(), found.end(), name) == found.end()) {
      found.push_back(std::move(name));
    }
  }
  const std::vector<std::string>& order = class_names(scheme);
  std::sort(found.begin(), found.end(), [&](const std::string& a, const std::string& b) {
    return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
  });
  return found;
}

}  // namespace clast
