#pragma once
/// Blocks above the ground of a scan.
#include <cstdint>
#include <span>
#include <vector>

#include "reconstruct/ground/ground.hpp"

namespace clast {

struct BlockOnGround {
  std::vector<std::uint32_t> points;  ///< ascending indices of its points
  Vec3 centre = Vec3::Zero();         ///< centre of its bounding box, m
  double height = 0.0;                ///< height above the ground, m
};

/// Blocks and ground points of a scan.
struct BlocksOnGround {
  std::vector<BlockOnGround> blocks;  ///< ordered by x, then y of their centres
  std::size_t central_block = 0;      ///< index of a high block near the centre of the scan
  std::vector<std::uint32_t> ground;  ///< indices of the ground points
};

/// Finds blocks as clusters of points that are higher than three times the ground's roughness. A
/// lower point belongs to a block if it is nearer to the straight extension of the block's wall
/// than to the ground. Both distances are relative to the roughness of the surface. Clusters that
/// are much smaller or lower than the others are not blocks.
BlocksOnGround find_blocks_on_ground(std::span<const Vec3> points, const Ground& ground,
                                     const GroundDetectionOptions& options = {});

}  // namespace clast
