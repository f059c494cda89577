#pragma once
/// How much rock may hide under what was seen of a block.
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/underside/free_space_grid.hpp"
#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

/// What nobody looked through under the lowest sheet of a closed mesh. What lies beside its plan is
/// not counted: rock there would have been seen. In m, m^2, m^3 if the mesh is in metres.
struct OccludedSpace {
  double volume = 0.0;  ///< above the ground
  /// Of the foot, just above the strip over the ground in which depths can't be told from the
  /// ground's. In the strip, and below, the block is taken to be no wider.
  double base_area = 0.0;
  double plan_area = 0.0;  ///< of the mesh
};

/// @param closed  closed below, by a closure that adds nothing
/// @param strip   height, m; three cubes at least are taken
OccludedSpace measure_occluded_space(const TriangleMesh& closed, const Plane& ground, double strip,
                                     const FreeSpaceGrid& free_space);

}  // namespace clast::reconstruct_detail
