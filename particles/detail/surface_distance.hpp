#pragma once
/// Hausdorff distance between a body and the surface of a simpler shape, by samples.
#include <span>
#include <vector>

#include "particles/detail/body_surface.hpp"
#include "shapes/inscribed_ball.hpp"

namespace clast::particles_detail {

/// Spacing of samples for stated errors, and for decisions during a fit, relative to L.
inline constexpr double kFineSpacing = 0.005, kCoarseSpacing = 0.01;

/// Samples a surface at a mean spacing and adds its vertices, or some of them if there are more.
std::vector<Vec3> sample_body(const BodySurface& body, double spacing);

struct LargestDistance {
  double value = 0.0;         ///< m
  Vec3 place = Vec3::Zero();  ///< where it is attained
  bool is_on_body = false;    ///< true: `place` is on the body, false: on the shape
};

/// Measures the Hausdorff distance of two surfaces. Points of the spheres are exposed points of a
/// spiral at the spacing, of the circles where two spheres meet, and corners where three meet.
/// @param body_samples  points of the surface of the body
/// @param spacing  of the points on the spheres, m
LargestDistance measure_surface_distance(const BodySurface& body,
                                         std::span<const Vec3> body_samples,
                                         std::span<const Ball> balls, double spacing);

/// Measures the largest distance of exposed points of a shape from a body, and of points of the
/// body that the shape covers from the exposed points.
LargestDistance measure_covering_distance(const BodySurface& body,
                                          std::span<const Vec3> covered_samples,
                                          std::span<const Vec3> exposed, double spacing);

}  // namespace clast::particles_detail
