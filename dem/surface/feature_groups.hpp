#pragma once
/// Groups of coplanar faces and of collinear edges of a block.
#include <cstdint>
#include <span>
#include <vector>

#include "dem/surface/surface_features.hpp"

namespace clast::dem_detail {

/// Groups of coplanar faces (planes) and of collinear convex edges (lines). Planes and lines have
/// common indices, lines after planes.
struct FeatureGroups {
  /// Group of each face; equal for faces connected over flat edges.
  std::vector<std::uint32_t> group_of_face;
  /// Group of each edge; equal for collinear convex edges.
  std::vector<std::uint32_t> group_of_edge;
  /// Index in `groups_of_vertices` of the first group of each vertex.
  std::vector<std::uint32_t> offsets;
  /// Groups of all vertices, ordered by vertex and sorted for each vertex.
  std::vector<std::uint32_t> groups_of_vertices;

  std::span<const std::uint32_t> groups_at(std::uint32_t vertex) const {
    return {groups_of_vertices.data() + offsets[vertex],
            groups_of_vertices.data() + offsets[vertex + 1]};
  }
};

FeatureGroups find_feature_groups(const SurfaceFeatures& block);

}  // namespace clast::dem_detail
