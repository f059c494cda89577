#pragma once
/// Partition of a block into compact parts for the narrow phase.
#include <cstdint>
#include <vector>

#include "dem/surface/surface_features.hpp"

namespace clast::dem_detail {

/// Edge or face of a block with a bounding sphere, in the body frame.
struct BlockSide {
  std::uint32_t feature = 0;
  bool is_face = false;
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
};

/// Four vertices, with coordinates by component, m.
struct VertexGroup {
  double x[4], y[4], z[4];
};

/// Group of adjacent vertices, edges and faces of a block, with a bounding sphere in the body
/// frame.
struct BlockPart {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
  double arm = 0.0;  ///< distance of `centre` from the body origin, m
  /// Range of its vertices in `BlockParts::vertices`.
  std::uint32_t first_vertex = 0, end_vertex = 0;
  /// Range of the same vertices in `BlockParts::vertex_groups`.
  std::uint32_t first_group = 0, end_group = 0;
  /// Range of its edges and faces in `BlockParts::sides`.
  std::uint32_t first_side = 0, end_side = 0;
};

/// Partition of the features of a block. Each vertex, edge and face that can be in contact belongs
/// to exactly one part.
struct BlockParts {
  std::vector<BlockPart> parts;
  std::vector<std::uint32_t> vertices;  ///< indices of the vertices, ordered by part
  /// The same vertices in groups of four, in the body frame. The last group of a part is filled
  /// with copies of its last vertex.
  std::vector<VertexGroup> vertex_groups;
  std::vector<BlockSide> sides;  ///< edges and faces, ordered by part
};

/// Partitions the features of a block by repeated bisection along their longest extent, into about
/// 1.4 sqrt(n) parts for n vertices.
BlockParts partition_block(const SurfaceFeatures& block);

}  // namespace clast::dem_detail
