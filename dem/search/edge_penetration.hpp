#pragma once
/// Initial penetration of edges, beyond the depth reported by contacts.
#include "core/types.hpp"
#include "dem/surface/block_surface.hpp"

namespace clast::dem_detail {

/// Returns the largest depth of edges of either surface in the other body, m: the depth of the
/// midpoint of the part inside, for each edge through a face; 0 if there is none. Regular contacts
/// of edges and faces are limited to half the smallest side; this function is for starts, which
/// have no history.
/// @param block  core of the rounded body; the radii are added
double edge_penetration_depth(const IndexedSurface& ground, const BlockSurface& block,
                              const Pose& ground_from_block);

}  // namespace clast::dem_detail
