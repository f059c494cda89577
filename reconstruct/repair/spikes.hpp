#pragma once
/// Removal of spikes.
#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

struct SpikeSummary {
  std::size_t count = 0;
  double max_height = 0.0;  ///< largest height of a spike
  Vec3 position = Vec3::Zero();
};

/// Flattens spikes in a few passes, the highest first. Inner vertices move to the centroid of their
/// neighbours, border vertices to the plane of the surrounding surface. A vertex is a spike if it
/// is high, and if flattening it clearly reduces the bending of the surface around its triangles.
/// Corners of coarse models and ends of ridges are kept.
/// @param mesh  consistently oriented
SpikeSummary flatten_spikes(TriangleMesh& mesh);

}  // namespace clast::reconstruct_detail
