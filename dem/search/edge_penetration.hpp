#pragma once
/// Penetration depth of edges at the start of a run.
#include "core/types.hpp"
#include "dem/surface/block_surface.hpp"

namespace clast::dem_detail {

/// Returns the largest depth to which an edge of one body penetrates the other, m; 0 if no edge
/// passes through a face. The depth is measured at the midpoint of the part of the edge inside the
/// other body.
/// @param block  core of the rounded block; both rounding radii are added to the depth
double edge_penetration_depth(const IndexedSurface& ground, const BlockSurface& block,
                              const Pose& ground_from_block);

}  // namespace clast::dem_detail
