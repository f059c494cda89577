#pragma once
/// Warning about self-intersecting surfaces.
#include "library/block.hpp"

namespace clast::pipeline_detail {

/// Adds a warning to `block` if `surface` intersects itself. The block must have been made from
/// `surface` without repair.
void warn_of_self_intersections(Block& block, const TriangleMesh& surface);

}  // namespace clast::pipeline_detail
