#include "dem/detail/segment_distance.hpp"

#include <algorithm>

namespace clast {
namespace {

/// Squared sine below which two lines count as parallel.
constexpr double kParallel = 1e-12;

}  // namespace

ClosestOnLines closest_on_lines(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v) {
  const Vec3 between = a - b;
  const double cosine = u.dot(v);
  const double sine_squared = 1.0 - cosine * cosine;
  const double along_u = u.dot(between);
  const double along_v = v.dot(between);
  return {(cosine * along_v - along_u) / sine_squared, (along_v - cosine * along_u) / sine_squared};
}

double segment_distance(const Vec3& a, const Vec3& u, double length_a, const Vec3& b, const Vec3& v,
                        double length_b) {
  const double cosine = u.dot(v);
  double s = 0.0;
  if (1.0 - cosine * cosine > kParallel) {
    s = std::clamp(closest_on_lines(a, u, b, v).first, 0.0, length_a);
  }
  const double t = std::clamp(v.dot(a + s * u - b), 0.0, length_b);
  s = std::clamp(u.dot(b + t * v - a), 0.0, length_a);
  return (a + s * u - b - t * v).norm();
}

}  // namespace clast
