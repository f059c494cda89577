#pragma once
/// Closest points of two segments.
#include <algorithm>

#include "core/types.hpp"

namespace clast::dem_detail {

struct Segment {
  Vec3 start = Vec3::Zero();
  Vec3 direction = Vec3::UnitX();  ///< unit
  double length = 0.0;             ///< m

  Vec3 point_at(double parameter) const { return start + parameter * direction; }
  Vec3 nearest_point(const Vec3& point) const {
    return point_at(std::clamp(direction.dot(point - start), 0.0, length));
  }
};

struct ClosestSegmentPoints {
  double first = 0.0;              ///< parameter on the first segment, m
  double second = 0.0;             ///< parameter on the second segment, m
  Vec3 separation = Vec3::Zero();  ///< vector from the second closest point to the first, m
  bool crossing = false;  ///< true if both closest points are in the interiors of the segments
  // Closest points of the infinite lines, and sine of the angle between them; all 0 if parallel.
  double line_first = 0.0, line_second = 0.0;
  double sine = 0.0;
};

ClosestSegmentPoints closest_segment_points(const Segment& a, const Segment& b);

/// Returns a lower bound of the displacement of a body before its segment `a` can cross the fixed
/// segment `b`, m; 0 if unknown. The displacement is the translation of `centre` plus 2
/// sin(angle/2) `radius` for a rotation by `angle` (docs/theory.md, Contact search).
/// @param closest  closest points of the two segments, with `crossing` false
double displacement_to_crossing(const ClosestSegmentPoints& closest, const Segment& a,
                                const Segment& b, const Vec3& centre, double radius);

}  // namespace clast::dem_detail
