#pragma once
/// Vertices that stand out of their neighbourhood.
#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

struct SpikeSummary {
  std::size_t count = 0;
  double highest = 0.0;  ///< distance of the farthest from its foot
  Vec3 position = Vec3::Zero();
};

/// Moves every vertex that stands out to its foot, in a few passes, the tallest first: inside the
/// surface to the centroid of its neighbours, at a border to the plane of the surface beyond its
/// triangles. It stands out if it is tall, and if the surface beyond its triangles bends much less
/// towards the foot than towards the vertex. Corners of coarse models and tips of ridges stay: the
/// surface around them goes on to the tip.
/// @param mesh  neighbours over edges face the same way
SpikeSummary flatten_spikes(TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
