#pragma once
/// What joins the contact points of a block: its planes and its straight edges.
#include <cstdint>
#include <span>
#include <vector>

#include "dem/surface/surface_features.hpp"

namespace clast::dem_detail {

/// Planes and lines in one numbering: a plane by a face of it, a line after all faces.
struct FeatureGroups {
  std::vector<std::uint32_t> group_of_face;  ///< faces joined over flat edges share it
  std::vector<std::uint32_t> group_of_edge;  ///< convex edges that go straight on share it
  std::vector<std::uint32_t> offsets;  ///< joints at vertex v: groups_of_vertices[offsets[v] ..]
  std::vector<std::uint32_t> groups_of_vertices;  ///< sorted within each vertex

  std::span<const std::uint32_t> groups_at(std::uint32_t vertex) const {
    return {groups_of_vertices.data() + offsets[vertex],
            groups_of_vertices.data() + offsets[vertex + 1]};
  }
};

FeatureGroups group_features(const SurfaceFeatures& block);

}  // namespace clast::dem_detail
