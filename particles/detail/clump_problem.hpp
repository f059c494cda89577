#pragma once
/// Body to which the balls of a clump are fitted, in units of its length.
#include <vector>

#include "massprops/moments.hpp"
#include "particles/detail/body_surface.hpp"
#include "particles/detail/distance_field.hpp"
#include "shapes/inscribed_ball.hpp"

namespace clast::particles_detail {

/// Ball inside the body that touches its surface.
struct TangentBall {
  Ball ball;
  Vec3 contact;
};

/// Body to fit, with samples and distances. The origin is its centre of mass and its length L is 1.
struct ClumpProblem {
  /// @param solid  the body is all points within `radius` of it
  ClumpProblem(TriangleMesh solid, double radius,
               const massprops_detail::SolidMoments& unit_moments);
  ClumpProblem(const ClumpProblem&) = delete;
  ClumpProblem& operator=(const ClumpProblem&) = delete;

  BodySurface body;
  massprops_detail::SolidMoments moments;  ///< of the true body, about the origin
  DistanceField field;
  std::vector<Vec3> surface;       ///< samples of the surface
  std::vector<Vec3> dense;         ///< more of them, and vertices
  std::vector<Vec3> interior;      ///< points of a lattice inside the body
  std::vector<TangentBall> balls;  ///< candidates
};

/// Returns the largest ball inside the body that touches the surface at `contact`.
/// @param normal  outward unit normal there
/// @cite ma2012
Ball shrink_tangent_ball(const BodySurface& body, const Vec3& contact, const Vec3& normal,
                         double largest);

/// Covers the samples by `count` candidate balls that are grown by the smallest common distance.
/// @param guess  initial estimate of that distance; affects the computing time, and the result
///               within the precision of the search
std::vector<Ball> cover_greedily(const ClumpProblem& problem, std::size_t count, double guess);

/// Covers the samples by candidate balls that are grown by `growth`, chosen greedily.
std::vector<Ball> cover_completely(const ClumpProblem& problem, double growth);

}  // namespace clast::particles_detail
