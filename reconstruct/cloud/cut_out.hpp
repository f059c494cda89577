#pragma once
/// Sample points of a surface, and extraction of the parts nearest to some of them.
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/repair/components.hpp"

namespace clast::reconstruct_detail {

/// Samples about 60,000 points uniformly over the surface; deterministic.
std::vector<Vec3> sample_surface_points(const TriangleMesh& mesh);

/// Returns the components of triangles whose vertices and centroid are nearest to `block`, without
/// triangles attached by a single edge; the largest first.
/// @param tree  of the points on `sheet`
/// @param block  indices of the points on the block
std::vector<Component> extract_nearest_components(const TriangleMesh& sheet, const PointTree& tree,
                                                  std::span<const std::uint32_t> block);

}  // namespace clast::reconstruct_detail
