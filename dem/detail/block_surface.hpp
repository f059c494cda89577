#pragma once
/// The surface of a block with what every contact search needs of it.
#include "dem/detail/block_joints.hpp"
#include "dem/detail/block_parts.hpp"
#include "dem/detail/indexed_surface.hpp"

namespace clast::dem_detail {

/// One per shape: in a pile thousands of pairs refer to a few of these, so that they stay in the
/// caches.
struct BlockSurface : IndexedSurface {
  explicit BlockSurface(const SpheroPolyhedron& body)
      : IndexedSurface(indexed_surface(body)),
        parts(block_parts(features)),
        joints(block_joints(features)) {}
  BlockParts parts;
  BlockJoints joints;
};

}  // namespace clast::dem_detail
