#pragma once
/// Closed body of a partly visible block, star-shaped about the centre of its ellipsoid.
#include <functional>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/deposit/detail/prior_ellipsoid.hpp"

namespace clast::reconstruct_detail {

struct StarBody {
  TriangleMesh mesh;                     ///< closed, outward, m
  std::vector<bool> is_vertex_observed;  ///< false on the estimated side; one per vertex
  double visible_fraction = 1.0;         ///< observed area over the area of the body
};

/// Makes a closed surface whose distance from a centre is a function of direction. In the frame in
/// which the ellipsoid is the unit sphere, the radius in a direction is interpolated linearly
/// between the nearest points. Beyond the points, it tends to 0.85 of the mean observed radius with
/// the angle from the nearest point, and the surface stays below those tangent planes that have
/// nearly all visible points below them, as the surface of a convex body does.
/// Unobserved vertices in free space move towards the centre until they are outside it.
/// @param points  points and normals of the visible surface, at least 12
/// @param spacing  point spacing, m
/// @param is_free  true for positions in observed free space; empty if none is known
StarBody fit_star_body(std::span<const SurfaceSample> points, const Ellipsoid& ellipsoid,
                       double spacing, const std::function<bool(const Vec3&)>& is_free = {});

}  // namespace clast::reconstruct_detail
