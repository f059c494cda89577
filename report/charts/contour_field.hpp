#pragma once
/// Smooth interpolation of scattered values, drawn as bands and contour lines.
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::report_detail {

/// Thin-plate spline: smooth surface through scattered values in the plane.
/// @cite duchon1977
class ThinPlateSpline {
 public:
  /// Computes the spline through given values.
  /// @param places  distinct points, not all collinear
  /// @param values  value at each point
  ThinPlateSpline(std::span<const Vec2> places, std::span<const double> values);

  double value_at(const Vec2& place) const;

 private:
  std::vector<Vec2> places_;
  Vec2 centre_;
  double scale_ = 1.0;
  std::vector<double> weights_;  ///< weights of the points, then coefficients of 1, x and y
};

/// Returns the vertices of the convex hull, counter-clockwise. There are fewer than three if all
/// points are collinear.
std::vector<Vec2> plan_convex_hull(std::span<const Vec2> places);
/// True if a point is inside the hull, within a tolerance.
bool is_inside(std::span<const Vec2> hull, const Vec2& place);

/// Formats the region inside a convex hull where a surface is at least `level`, as data of an SVG
/// path.
std::string format_band_path(const ThinPlateSpline& surface, std::span<const Vec2> hull,
                             double level, double side);

struct ContourLine {
  std::string path;                           ///< SVG path data; empty if there is no line
  std::vector<std::pair<Vec2, Vec2>> pieces;  ///< the same line as segments
};
ContourLine trace_contour_line(const ThinPlateSpline& surface, std::span<const Vec2> hull,
                               double level, double side);

}  // namespace clast::report_detail
