#pragma once
/// Unobserved space below the observed part of a block.
#include "mesh/triangle_mesh.hpp"
#include "reconstruct/underside/free_space_grid.hpp"
#include "reconstruct/underside/underside.hpp"

namespace clast::reconstruct_detail {

/// Unobserved volume below a closed mesh, within its plan; rock outside its plan would have been
/// observed. In m, m^2, m^3 if the mesh is in metres.
struct OccludedSpace {
  double volume = 0.0;  ///< above the ground
  /// Area of the base just above the strip over the ground in which depths are ambiguous. The block
  /// is assumed to be no wider in and below the strip.
  double base_area = 0.0;
  double plan_area = 0.0;  ///< of the mesh
};

/// Measures the unobserved space.
/// @param closed  closed below by a membrane
/// @param strip  height, m; at least three cubes
OccludedSpace measure_occluded_space(const TriangleMesh& closed, const Plane& ground, double strip,
                                     const FreeSpaceGrid& free_space);

}  // namespace clast::reconstruct_detail
