#pragma once
/// Selection of a block above the ground of a scan.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "reconstruct/ground/blocks_on_ground.hpp"

namespace clast::reconstruct_detail {

/// Block above the ground, with data for closing its underside, and notes.
struct ChosenBlock {
  std::vector<std::uint32_t> point_indices;  ///< ascending
  std::vector<Vec3> points;
  Vec3 centre = Vec3::Zero();  ///< centre of its bounding box
  Plane ground;                ///< tangent plane of the ground below it
  std::vector<std::string> notes;
};

/// Selects the block near the centre of the scan.
/// @param found  blocks of the scan, at least one
ChosenBlock choose_block_on_ground(const std::vector<Vec3>& points, const Ground& ground,
                                   const BlocksOnGround& found);

/// Returns the note on a scan with `count` blocks, of which one is used.
std::string note_other_blocks(std::size_t count);

/// Throws the error for a scan that contains only ground.
/// @param fraction  fraction of the scan that is ground
[[noreturn]] void throw_only_ground_error(const std::string& name, double fraction);

}  // namespace clast::reconstruct_detail
