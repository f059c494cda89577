#pragma once
/// Scans of balls on a floor.
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "core/types.hpp"

namespace clast {

struct FloorBall {
  Vec3 centre;
  double radius;
};

/// Points on the upper parts of balls on a floor, and on the floor between them, as seen from above
/// and from the sides. Places inside a ball and below the balls are not seen.
inline std::vector<Vec3> balls_on_floor(const std::vector<FloorBall>& balls, double half_width,
                                        double spacing, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  const auto is_free = [&](const Vec3& p) {
    for (const FloorBall& ball : balls) {
      if ((p - ball.centre).norm() < 0.999 * ball.radius) return false;
    }
    return true;
  };
  for (const FloorBall& ball : balls) {
    const auto count =
        static_cast<int>(4.0 * kPi * ball.radius * ball.radius / (spacing * spacing));
    for (int i = 0; i < count; ++i) {
      const Vec3 direction = random.unit_vector();
      const Vec3 p = ball.centre + (ball.radius + 0.1 * spacing * random.normal()) * direction;
      if (direction.z() > -0.5 && p.z() > 0.0 && is_free(ball.centre + ball.radius * direction)) {
        points.push_back(p);
      }
    }
  }
  const auto count = static_cast<int>(4.0 * half_width * half_width / (spacing * spacing));
  for (int i = 0; i < count; ++i) {
    const Vec3 p(random.uniform(-half_width, half_width), random.uniform(-half_width, half_width),
                 0.1 * spacing * random.normal());
    bool hidden = false;
    for (const FloorBall& ball : balls) {
      hidden |= (p - ball.centre).head<2>().norm() < 0.5 * ball.radius;
    }
    if (!hidden) points.push_back(p);
  }
  return points;
}

}  // namespace clast
