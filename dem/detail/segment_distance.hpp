#pragma once
/// Distances between lines and segments.
#include "core/types.hpp"

namespace clast {

/// Where two lines come closest, as lengths along their unit directions.
struct ClosestOnLines {
  double first = 0.0;
  double second = 0.0;
};

/// @param a, u  a point and the unit direction of the first line; b, v of the second, not parallel
ClosestOnLines closest_on_lines(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v);

/// Distance between the segments from `a` and `b` along their unit directions.
double segment_distance(const Vec3& a, const Vec3& u, double length_a, const Vec3& b, const Vec3& v,
                        double length_b);

}  // namespace clast
