#pragma once
/// A surface seen through points, and what of it belongs to some of them.
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/cloud/cloud.hpp"
#include "reconstruct/repair/components.hpp"

namespace clast::reconstruct_detail {

/// About 60,000 points spread over the surface by area; the same for the same mesh.
std::vector<Vec3> sample_surface_points(const TriangleMesh& mesh);

/// Components of the triangles whose corners and middle all lie nearest to one of `block`, without
/// triangles that hang on by one edge; the largest first, none where there are no such triangles.
/// @param tree   of the points over `sheet`
/// @param block  numbers of those points that are on the block
std::vector<Component> extract_nearest_components(const TriangleMesh& sheet, const PointTree& tree,
                                             std::span<const std::uint32_t> block);

}  // namespace clast::reconstruct_detail
