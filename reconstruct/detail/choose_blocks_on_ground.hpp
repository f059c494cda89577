#pragma once
/// Which of the blocks that stand on the ground of a scan are asked for.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "reconstruct/ground/blocks_on_ground.hpp"

namespace clast::reconstruct_detail {

/// A block on the ground, with what its closing needs.
struct ChosenBlock {
  std::vector<std::uint32_t> point_indices;  ///< of its points, ascending
  std::vector<Vec3> points;
  Vec3 centre = Vec3::Zero();  ///< of its box
  Plane ground;                ///< that touches the ground below it
};

/// All of them with `split`, else the one near the middle.
struct ChosenBlocks {
  std::vector<ChosenBlock> blocks;
  std::vector<std::string> notes;
};

/// @param name  of the scan, for messages
/// @throws GeometryError  nothing that rises from the ground is a block
ChosenBlocks choose_blocks_on_ground(const std::vector<Vec3>& points, const Ground& ground,
                                     const std::string& name, bool split);

/// @param share  of the scan that is ground
[[noreturn]] void throw_bare_ground(const std::string& name, double fraction);

}  // namespace clast::reconstruct_detail
