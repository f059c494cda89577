#pragma once
/// Treatment of components beside or inside the block: bubbles, duplicate sheets and islands.
#include <span>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/detail/repair_log.hpp"
#include "reconstruct/repair/repair.hpp"

namespace clast::reconstruct_detail {

/// Removes and records copies of the block's surface, open sheets on it, and small components
/// beside it or loose inside it. Closed components inside are bubbles. They are counted and, if
/// requested, added as cavities with inward orientation.
/// @param block  closed
/// @param components  components of the mesh, the block first
/// @throws GeometryError  if another component is too large for an island, so that it is a second
///                        block or another part of this block
void remove_other_components(TriangleMesh& block, std::span<const SurfaceComponent> components,
                             const RepairOptions& options, RepairLog& log);

}  // namespace clast::reconstruct_detail
