#pragma once
/// What stands beside the block in a mesh, or in it: bubbles, sheets scanned twice, islands.
#include <span>

#include "mesh/triangle_mesh.hpp"
#include "reconstruct/repair/components.hpp"
#include "reconstruct/repair/detail/repair_log.hpp"
#include "reconstruct/repair/repair.hpp"

namespace clast::reconstruct_detail {

/// Drops and notes copies of the block's surface, open sheets that lie on it, small components
/// beside it and loose ones in it. Closed ones in it are bubbles: counted, and where they are to be
/// kept added to the block, facing the other way than it does.
/// @param block       closed
/// @param components  of the mesh, the one that became the block first
/// @throws GeometryError  another component is too large to be an island: a second block, or
///                        another part of this one
void remove_other_components(TriangleMesh& block, std::span<const Component> components,
                         const RepairOptions& options, RepairLog& log);

}  // namespace clast::reconstruct_detail
