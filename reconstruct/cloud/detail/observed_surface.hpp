#pragma once
/// Which part of a closed surface through points has been seen.
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

struct ObservedSurface {
  std::vector<bool> observed;        ///< of each triangle
  std::size_t gaps = 0;              ///< holes so small that they count as seen: filled
  double gap_fraction = 0.0;         ///< of the area of the surface
  Vec3 gap_position = Vec3::Zero();  ///< in the largest gap, m
};

/// Each triangle has an empty ball, which contains no point. Between points scattered at random the
/// largest is about two spacings in radius; a patch of triangles with larger ones is a hole. Where
/// the density falls the balls grow with the spacing: a patch is no hole if its largest ball is
/// explained by the sparsest points around it. A hole extends to where the balls are no larger than
/// usual.
/// @param closed    its vertices are the points
/// @param spacings  of the points, as `compute_local_spacings` gives them, m
/// @param rim       radius of the ball at which a hole ends, in spacings
ObservedSurface find_observed_surface(const TriangleMesh& closed, std::span<const double> spacings,
                                      double ball_radius);

}  // namespace clast::reconstruct_detail
