#include "particles/ball_union.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "massprops/moments.hpp"
#include "particles/detail/sphere_patches.hpp"

namespace clast {

namespace {

void check_balls(std::span<const Ball> balls) {
  if (balls.empty()) throw InputError("a union of balls needs at least one ball");
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls[i].centre.allFinite() && std::isfinite(balls[i].radius) && balls[i].radius > 0.0) {
      continue;
    }
    throw InputError("ball " + std::to_string(i + 1) + ": centre " + format_point(balls[i].centre) +
                     ", radius " + format_significant(balls[i].radius, 6) +
                     " m; the radius must be positive and all values finite");
  }
}

Vec3 mean_centre(std::span<const Ball> balls) {
  Vec3 sum = Vec3::Zero();
  for (const Ball& ball : balls) sum += ball.centre - balls.front().centre;
  return balls.front().centre + sum / static_cast<double>(balls.size());
}

}  // namespace

MassProperties ball_union_mass_properties(std::span<const Ball> balls, double density) {
  check_balls(balls);
  massprops_detail::check_density(density);
  const Vec3 origin = mean_centre(balls);
  return massprops_detail::to_mass_properties(
      particles_detail::integrate_ball_union(balls, origin).moments, origin, Mat3::Identity(),
      density);
}

std::vector<double> exposed_areas(std::span<const Ball> balls) {
  check_balls(balls);
  return particles_detail::integrate_ball_union(balls, mean_centre(balls)).areas;
}

}  // namespace clast
