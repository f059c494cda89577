#pragma once
/// Separation of the detailed surfaces of blocks that came to rest by their cores.
#include <span>
#include <vector>

#include "samples/deposit/deposit_block.hpp"

namespace clast {

/// Separates surfaces that overlap because the cores are only similar to them, by small
/// displacements. Blocks may be pressed into the floor, as into soil.
/// @param poses  world_from_body of each block; moved
/// @param allowed  overlap that may remain, m
/// @return largest remaining overlap of a vertex with another block, m
double separate_surfaces(std::span<const VirtualBlock> blocks, std::vector<Pose>& poses,
                         double allowed, unsigned threads);

}  // namespace clast
