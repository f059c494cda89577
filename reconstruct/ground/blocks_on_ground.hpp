#pragma once
/// The blocks that rise from the ground of a scan.
#include <cstdint>
#include <span>
#include <vector>

#include "reconstruct/ground/ground.hpp"

namespace clast {

/// A block on a ground.
struct BlockOnGround {
  std::vector<std::uint32_t> points;  ///< numbers of its points, ascending
  Vec3 centre = Vec3::Zero();         ///< of its box, m
  double height = 0.0;                ///< above the ground, m
};

/// What rises from the ground.
struct BlocksOnGround {
  std::vector<BlockOnGround> blocks;  ///< ordered by x, then y, of their centres
  std::size_t central = 0;            ///< the one that is high and near the middle of the scan
  std::vector<std::uint32_t> ground;  ///< numbers of the points that lie on the ground
};

/// Groups what is higher than three times the ground's roughness, and shares out the strip below
/// that: a point there belongs to the block if the wall above, carried on straight, passes closer
/// to it than the ground does (both by their own roughness). Components a good deal smaller than
/// the largest, and components that rise little, are no blocks.
BlocksOnGround find_blocks_on_ground(std::span<const Vec3> points, const Ground& ground,
                                     const GroundOptions& options = {});

}  // namespace clast
