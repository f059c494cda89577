#pragma once
/// Sampling of points on a surface, and extraction of the surface parts nearest to selected points.
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/repair/components.hpp"

namespace clast::reconstruct_detail {

/// Samples about 60,000 points uniformly over the surface. The result is deterministic.
std::vector<Vec3> sample_surface_points(const TriangleMesh& mesh);

/// Returns the components of the surface nearest to the points `block`, the largest first. A
/// triangle is included if all of its vertices and its centroid are nearest to one of these points.
/// Triangles attached by a single edge are removed.
/// @param tree  tree of the points sampled on `sheet`
/// @param block  indices of the points on the block
std::vector<SurfaceComponent> extract_nearest_components(const TriangleMesh& sheet,
                                                         const PointTree& tree,
                                                         std::span<const std::uint32_t> block);

}  // namespace clast::reconstruct_detail
