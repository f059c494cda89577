#pragma once
/// Filling of a hole by a membrane refined to the density of its rim.
///
/// Unlike `fill_holes` of holes.hpp, whose faired filling continues the slope of the rim: the most
/// probable rock behind a gap, but for a whole underside it may change the volume by tenths. A
/// bracket needs a membrane that adds nothing beyond the rim (the lower bound), with a shape for
/// lowering it.
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Triangles and new vertices of a hole filling.
struct HolePatch {
  std::vector<Vec3> vertices;                     ///< new, numbered after those of the mesh
  std::vector<TriangleMesh::Triangle> triangles;  ///< oriented like their neighbours
  /// Relative deflection of each new vertex under uniform pressure, with maximum 1; a parabola for
  /// a round rim.
  std::vector<double> deflection;
};

/// Fills a loop with a membrane: triangulated, refined to the rim's density, and harmonic
/// (cotangent weights). If there is no triangulation, with a star about the rim's centre.
/// @param loop  from `boundary_loops`
/// @cite liepa2003
HolePatch fill_with_membrane(const TriangleMesh& mesh, const std::vector<std::uint32_t>& loop);

}  // namespace clast::reconstruct_detail
