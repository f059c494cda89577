#pragma once
/// How deep a block starts inside the ground where edges pierce it, beyond the depth that contacts
/// report.
#include "core/types.hpp"
#include "dem/surface/block_surface.hpp"

namespace clast::dem_detail {

/// How deep edges of either surface lie in the other body, m: of every edge that goes through a
/// face, the middle of what is inside. 0 when none does. Contacts of edges and faces are found up
/// to half the smallest side of the block only; this is for a start, which has no history.
/// @param block  of a rounded body the core; the radii are added to what it pierces
double edge_penetration_depth(const IndexedSurface& ground, const BlockSurface& block,
                              const Pose& ground_from_block);

}  // namespace clast::dem_detail
