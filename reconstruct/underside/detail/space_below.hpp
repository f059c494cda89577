#pragma once
/// Unobserved space below the observed part of a block.
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/underside/free_space_grid.hpp"
#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

/// Volume below a closed mesh that was not observed to be free. Only the space within its plan is
/// included, because rock outside it would have been observed. Units are those of the mesh.
struct OccludedSpace {
  double volume = 0.0;  ///< volume above the ground
  /// Plan area in which the block may reach the ground. It is measured at the top of a strip above
  /// the ground, because free space within the strip is ambiguous.
  double base_area = 0.0;
  double plan_area = 0.0;  ///< plan area of the mesh
};

/// Measures the space below a block that was not observed to be free.
/// @param closed  mesh that is closed below by a membrane
/// @param strip  height of the strip above the ground; raised to three cubes of the grid if lower
OccludedSpace measure_occluded_space(const TriangleMesh& closed, const Plane& ground, double strip,
                                     const FreeSpaceGrid& free_space);

}  // namespace clast::reconstruct_detail
