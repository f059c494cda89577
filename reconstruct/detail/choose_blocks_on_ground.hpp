#pragma once
/// Selection of blocks above the ground of a scan.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "reconstruct/ground/blocks_on_ground.hpp"

namespace clast::reconstruct_detail {

/// Block above the ground, with data for its closure.
struct ChosenBlock {
  std::vector<std::uint32_t> point_indices;  ///< ascending
  std::vector<Vec3> points;
  Vec3 centre = Vec3::Zero();  ///< of its box
  Plane ground;                ///< tangent plane of the ground below it
};

/// Selected blocks: all with `split`, otherwise the one near the centre.
struct ChosenBlocks {
  std::vector<ChosenBlock> blocks;
  std::vector<std::string> notes;
};

/// Selects blocks.
/// @param name  of the scan, for messages
/// @throws GeometryError  if no part above the ground is a block
ChosenBlocks choose_blocks_on_ground(const std::vector<Vec3>& points, const Ground& ground,
                                     const std::string& name, bool split);

/// Throws the error for a scan of ground only.
/// @param fraction  of the scan that is ground
[[noreturn]] void throw_bare_ground(const std::string& name, double fraction);

}  // namespace clast::reconstruct_detail
