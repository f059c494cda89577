#pragma once
/// Blocks above the ground of a scan.
#include <cstdint>
#include <span>
#include <vector>

#include "reconstruct/ground/ground.hpp"

namespace clast {

struct BlockOnGround {
  std::vector<std::uint32_t> points;  ///< ascending indices of its points
  Vec3 centre = Vec3::Zero();         ///< of its box, m
  double height = 0.0;                ///< above the ground, m
};

/// Blocks and ground points of a scan.
struct BlocksOnGround {
  std::vector<BlockOnGround> blocks;  ///< ordered by x, then y of their centres
  std::size_t central = 0;            ///< index of a high block near the centre of the scan
  std::vector<std::uint32_t> ground;  ///< indices of the ground points
};

/// Finds blocks as clusters above three times the ground's roughness. Points in the strip below
/// belong to a block if the straight extension of the wall above is nearer than the ground,
/// relative to their roughnesses. Much smaller or lower clusters are not blocks.
BlocksOnGround find_blocks_on_ground(std::span<const Vec3> points, const Ground& ground,
                                     const GroundDetectionOptions& options = {});

}  // namespace clast
