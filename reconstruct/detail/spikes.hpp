#pragma once
/// Vertices that stand out of their neighbourhood.
#include <cstddef>

#include "shapes/triangle_mesh.hpp"

namespace clast::detail {

struct Spikes {
  std::size_t count = 0;
  double highest = 0.0;  ///< distance of the farthest from its neighbours' centroid
  Vec3 place = Vec3::Zero();
};

/// Moves every vertex that is farther from the centroid of its neighbours than 1.5 times their mean
/// distance from it to that centroid, in a few passes, where it also stands taller than 2.5 median
/// edges of the mesh, or than 1.2 where the surface around it is smooth without it. That leaves the
/// corners of coarse models and the tips of ridges alone. Vertices at a border stay.
Spikes flatten_spikes(TriangleMesh& mesh);

}  // namespace clast::detail
