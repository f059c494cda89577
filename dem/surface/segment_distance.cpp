#include "dem/surface/segment_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace clast::dem_detail {
namespace {

/// Squared sine below which two lines count as parallel.
constexpr double kParallel = 1e-12;
constexpr double kHalfPi = 0.5 * std::numbers::pi;

}  // namespace

ClosestSegmentPoints closest_segment_points(const Segment& a, const Segment& b) {
  const Vec3 apart = a.start - b.start;
  const double cosine = a.direction.dot(b.direction);
  const double sine_squared = 1.0 - cosine * cosine;
  const double along_a = a.direction.dot(apart);
  const double along_b = b.direction.dot(apart);
  ClosestSegmentPoints closest;
  if (sine_squared > kParallel) {
    closest.sine = std::sqrt(sine_squared);
    closest.line_first = (cosine * along_b - along_a) / sine_squared;
    closest.line_second = (along_b - cosine * along_a) / sine_squared;
    closest.first = closest.line_first;
    closest.second = closest.line_second;
    closest.crossing = closest.first >= 0.0 && closest.first <= a.length && closest.second >= 0.0 &&
                       closest.second <= b.length;
  }
  if (!closest.crossing) {
    const double s = std::clamp(closest.first, 0.0, a.length);
    closest.second = std::clamp(along_b + s * cosine, 0.0, b.length);
    closest.first = std::clamp(closest.second * cosine - along_a, 0.0, a.length);
  }
  closest.separation = apart + closest.first * a.direction - closest.second * b.direction;
  return closest;
}

double displacement_to_crossing(const ClosestSegmentPoints& closest, const Segment& a,
                                const Segment& b, const Vec3& centre, double radius) {
  // A segment that ends before the other's line stays on its side of the plane through that line
  // and the common normal, which rotates about it up to pi/2 over the sine faster than the body.
  const double turning = kHalfPi / (radius * closest.sine);
  const auto displacement_of = [&](double beyond, const Segment& of, double line,
                                   const Segment& other, double moving) {
    if (!(beyond > 0.0)) return 0.0;
    const Vec3 out = of.point_at(line < 0.0 ? 0.0 : of.length) - other.start;
    const double along = other.direction.dot(out);
    const double arm = std::sqrt(std::max(0.0, out.squaredNorm() - along * along));
    return beyond * closest.sine / (moving + turning * arm);
  };
  const double first_beyond = std::max(-closest.line_first, closest.line_first - a.length);
  const double second_beyond = std::max(-closest.line_second, closest.line_second - b.length);
  // Relative to the body, points farther from its centre than `radius` move farther.
  const Vec3 end = b.point_at(closest.line_second < 0.0 ? 0.0 : b.length);
  const double moving = std::max(1.0, (end - centre).norm() / radius);
  const double displacement =
      std::max(displacement_of(first_beyond, a, closest.line_first, b, 1.0),
               displacement_of(second_beyond, b, closest.line_second, a, moving));
  return std::min(displacement, closest.sine * radius);
}

}  // namespace clast::dem_detail
