#pragma once
/// Exposed patches of the spheres of a union of balls, and integrals over them.
#include <span>
#include <vector>

#include "massprops/moments.hpp"
#include "shapes/inscribed_ball.hpp"

namespace clast::particles_detail {

/// Moments of a union of balls and exposed area of each ball.
struct BallUnionIntegrals {
  massprops_detail::SolidMoments moments;  ///< about the origin that was passed
  std::vector<double> areas;               ///< m^2
};

/// Integrates over the exposed patches of all spheres.
///
/// Radii are changed by up to 1e-11 of themselves, each differently. So no three spheres meet in a
/// common circle and no two balls coincide, where rounding would decide which sphere is exposed.
/// @param balls  radii positive
BallUnionIntegrals integrate_ball_union(std::span<const Ball> balls, const Vec3& origin);

}  // namespace clast::particles_detail
