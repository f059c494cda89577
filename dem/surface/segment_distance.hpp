#pragma once
/// Where two segments come closest.
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

struct SegmentDistance {
  double first = 0.0;              ///< along the first segment, m
  double second = 0.0;             ///< along the second, m
  Vec3 separation = Vec3::Zero();  ///< from the point on the second to the one on the first
  bool crossing = false;  ///< both points are inside, where the lines themselves are closest
  // The same of the lines, and the sine of the angle between them; all 0 where they are parallel.
  double line_first = 0.0, line_second = 0.0;
  double sine = 0.0;
};

SegmentDistance closest_points(const Segment& a, const Segment& b);

/// How far a body may move that carries the first segment before the two cross, m; 0 where that is
/// not known. Its way counts as the shift of its centre and `radius` times the chord of its turn
/// together (docs/theory.md, Contact search).
/// @param closest  of these two, not crossing
double displacement_to_crossing(const SegmentDistance& closest, const Segment& a, const Segment& b,
                                const Vec3& centre, double radius);

}  // namespace clast::dem_detail
