#pragma once
/// A smooth surface through values at scattered places of a picture, as bands and contour lines.
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::report_detail {

/// The smoothest surface in the sense of a thin plate through the values: the sum of r^2 log r
/// about the places and a plane.
/// @cite duchon1977
class ThinPlateSpline {
 public:
  /// @param places  not all on one line; no two the same
  /// @param values  as many
  ThinPlateSpline(std::span<const Vec2> places, std::span<const double> values);

  double at(const Vec2& place) const;

 private:
  std::vector<Vec2> places_;
  Vec2 centre_;
  double scale_ = 1.0;
  std::vector<double> weights_;  ///< of the places, then of 1, x, y
};

/// Corners of the convex hull, counter-clockwise; fewer than three where all are on one line.
std::vector<Vec2> hull_of(std::span<const Vec2> places);
/// A little inwards counts as inside.
bool is_inside(std::span<const Vec2> hull, const Vec2& place);

/// Where the surface is at least so high, within the hull: path data of one SVG path, closed parts
/// that abut. Found on a lattice of equilateral triangles with sides of `side` px, in each of which
/// the surface counts as flat.
std::string format_band_path(const ThinPlateSpline& surface, std::span<const Vec2> hull, double level,
                      double side);

/// A contour line.
struct ContourLine {
  std::string path;                           ///< data of an SVG path; empty: none
  std::vector<std::pair<Vec2, Vec2>> pieces;  ///< the same
};
ContourLine trace_contour_line(const ThinPlateSpline& surface, std::span<const Vec2> hull, double level,
                         double side);

}  // namespace clast::report_detail
