#pragma once
/// Distinction of observed parts and holes of a closed surface through measured points.
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

struct ObservedSurface {
  std::vector<bool> is_observed;     ///< one flag per triangle
  std::size_t gaps = 0;              ///< number of holes that are small enough to be filled
  double gap_fraction = 0.0;         ///< area of these gaps over the surface area
  Vec3 gap_position = Vec3::Zero();  ///< position in the largest gap, m
};

/// Finds the observed part of a surface. Each triangle has an empty ball, which touches its
/// vertices and contains no point. A large ball indicates a hole. For randomly scattered points,
/// the largest radius is about two spacings. A patch of triangles with larger balls is a hole,
/// unless the points around it are equally sparse. The hole extends to the triangles whose balls
/// have the usual size.
/// @param closed  closed surface, whose vertices are the points
/// @param spacings  local point spacings (`compute_local_spacings`), m
/// @param ball_radius  radius of empty balls above which triangles belong to a hole, in spacings
ObservedSurface find_observed_surface(const TriangleMesh& closed, std::span<const double> spacings,
                                      double ball_radius);

}  // namespace clast::reconstruct_detail
