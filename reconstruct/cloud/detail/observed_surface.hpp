#pragma once
/// Observed part of a closed surface through points.
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

struct ObservedSurface {
  std::vector<bool> observed;        ///< per triangle
  std::size_t gaps = 0;              ///< number of holes small enough to count as observed: filled
  double gap_fraction = 0.0;         ///< of the surface area
  Vec3 gap_position = Vec3::Zero();  ///< in the largest gap, m
};

/// Finds the observed part by the empty ball of each triangle. For randomly scattered points the
/// largest radius is about two spacings; a patch of larger balls is a hole, unless the sparsest
/// points around explain them. A hole extends to where the balls have usual size.
/// @param closed  its vertices are the points
/// @param spacings  of the points, from `compute_local_spacings`, m
/// @param ball_radius  at the border of a hole, in spacings
ObservedSurface find_observed_surface(const TriangleMesh& closed, std::span<const double> spacings,
                                      double ball_radius);

}  // namespace clast::reconstruct_detail
