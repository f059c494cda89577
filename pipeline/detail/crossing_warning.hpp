#pragma once
/// Warning about self-intersecting surfaces.
#include "library/block.hpp"

namespace clast::pipeline_detail {

/// Adds a warning if `surface`, from which `block` was made without repair, intersects itself.
void warn_of_self_intersections(Block& block, const TriangleMesh& surface);

}  // namespace clast::pipeline_detail
