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

/// Group of adjacent block features with a bounding sphere in the body frame.
struct BlockPart {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
  double arm = 0.0;                                ///< distance of `centre` from the body origin, m
  std::uint32_t first_vertex = 0, end_vertex = 0;  ///< range of BlockParts::vertices
  std::uint32_t first_side = 0, end_side = 0;      ///< range of BlockParts::sides
};

/// Parts of a block. Each feature that can be in contact (pointed vertex, convex edge or face)
/// belongs to exactly one part.
struct BlockParts {
  std::vector<BlockPart> parts;
  std::vector<std::uint32_t> vertices;  ///< by part
  std::vector<BlockSide> sides;         ///< by part
};

/// Partitions the features by repeated bisection along their longest extent. About 2 sqrt(n) parts
/// for n vertices balance the cost of testing parts with that of testing features.
BlockParts partition_block(const SurfaceFeatures& block);

}  // namespace clast::dem_detail
