#pragma once
/// What joins the contact points of a block: its planes and its straight edges.
#include <cstdint>
#include <span>
#include <vector>

#include "dem/surface/surface_features.hpp"

namespace clast::dem_detail {

/// Planes and lines in one numbering: a plane by a face of it, a line after all faces.
struct BlockJoints {
  std::vector<std::uint32_t> plane_of_face;  ///< faces joined over flat edges share it
  std::vector<std::uint32_t> line_of_edge;   ///< convex edges that go straight on share it
  std::vector<std::uint32_t> offsets;        ///< joints at vertex v: at_vertex[offsets[v] ..]
  std::vector<std::uint32_t> at_vertex;      ///< sorted within each vertex

  std::span<const std::uint32_t> at(std::uint32_t vertex) const {
    return {at_vertex.data() + offsets[vertex], at_vertex.data() + offsets[vertex + 1]};
  }
};

BlockJoints block_joints(const SurfaceFeatures& block);

}  // namespace clast::dem_detail
