#pragma once
/// Blocks that edges of the ground run through, or that run into it, deeper than contacts tell.
#include "core/types.hpp"
#include "dem/detail/block_surface.hpp"

namespace clast::dem_detail {

/// How deep edges of either surface lie in the other body, m: of every edge that goes through a
/// face, the middle of what is inside. 0 when none does. Contacts of edges and faces are told up to
/// half the smallest side of the block only; this is for a start, of which nothing is known.
/// @param block  of a rounded body the core; the radii are added to what it pierces
double pierced_depth(const IndexedSurface& ground, const BlockSurface& block,
                     const Pose& ground_from_block);

}  // namespace clast::dem_detail
