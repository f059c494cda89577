#pragma once
/// A surface that passes through itself.
#include "library/block.hpp"

namespace clast::pipeline_detail {

/// Adds a warning where triangles of `surface`, which `block` was made of as it is, cross.
void warn_of_self_intersections(Block& block, const TriangleMesh& surface);

}  // namespace clast::pipeline_detail
