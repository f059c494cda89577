#pragma once
/// Warning about self-intersecting surfaces.
#include "library/block.hpp"

namespace clast::pipeline_detail {

/// Adds a warning if `surface`, from which `block` was made without repair, intersects itself.
void add_self_intersection_warning(Block& block, const TriangleMesh& surface);

}  // namespace clast::pipeline_detail
