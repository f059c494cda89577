#pragma once
/// Groups of block features that connect contact points: planes and straight lines.
#include <cstdint>
#include <span>
#include <vector>

#include "dem/surface/surface_features.hpp"

namespace clast::dem_detail {

/// Planes and lines with common indices. A plane has the index of one of its faces; the lines are
/// numbered after all faces.
struct FeatureGroups {
  std::vector<std::uint32_t> group_of_face;  ///< equal for faces connected over flat edges
  std::vector<std::uint32_t> group_of_edge;  ///< equal for collinear convex edges
  std::vector<std::uint32_t> offsets;  ///< groups at vertex v: groups_of_vertices[offsets[v] ..]
  std::vector<std::uint32_t> groups_of_vertices;  ///< sorted for each vertex

  std::span<const std::uint32_t> groups_at(std::uint32_t vertex) const {
    return {groups_of_vertices.data() + offsets[vertex],
            groups_of_vertices.data() + offsets[vertex + 1]};
  }
};

FeatureGroups find_feature_groups(const SurfaceFeatures& block);

}  // namespace clast::dem_detail
