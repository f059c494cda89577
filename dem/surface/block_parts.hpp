#pragma once
/// A block cut into compact parts: one far from the ground is checked as a whole.
#include <cstdint>
#include <vector>

#include "dem/surface/surface_features.hpp"

namespace clast::dem_detail {

/// An edge or a face of a block with a ball around it, in the body frame.
struct BlockSide {
  std::uint32_t feature = 0;
  bool is_face = false;
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
};

/// Neighbouring features of a block, and a ball around their cores in the body frame.
struct BlockPart {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
  double arm = 0.0;                                ///< of its centre about the body's, m
  std::uint32_t first_vertex = 0, end_vertex = 0;  ///< of BlockParts::vertices
  std::uint32_t first_side = 0, end_side = 0;      ///< of BlockParts::sides
};

/// Every feature that can touch is in exactly one part: pointed vertices, convex edges, faces.
struct BlockParts {
  std::vector<BlockPart> parts;
  std::vector<std::uint32_t> vertices;  ///< part by part
  std::vector<BlockSide> sides;         ///< part by part
};

/// Halves the features across their longest extent until about 2 sqrt(vertices) parts are left:
/// then looking over the parts and looking into the few near the ground cost about the same.
BlockParts partition_block(const SurfaceFeatures& block);

}  // namespace clast::dem_detail
