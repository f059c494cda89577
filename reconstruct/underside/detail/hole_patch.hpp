#pragma once
/// Filling of a hole by a membrane refined to the density of its rim.
///
/// `fill_holes` (holes.hpp), in contrast, continues the slope of the rim. This is the most probable
/// surface of a gap, but it may change the volume by tens of per cent for a whole underside. A
/// volume bracket needs a membrane that adds nothing beyond the rim.
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Triangles and new vertices of a hole filling.
struct HolePatch {
  std::vector<Vec3> vertices;  ///< new vertices, numbered after those of the mesh
  std::vector<TriangleMesh::Triangle> triangles;  ///< oriented like their neighbours
  /// Deflection of each new vertex under uniform pressure, scaled to a maximum of 1. For a round
  /// rim, it is a paraboloid.
  std::vector<double> deflection;
};

/// Fills a loop with a membrane. It is triangulated, refined to the density of the rim, and made
/// harmonic with cotangent weights. Without a triangulation, a star about the rim's centre is used.
/// @param loop  boundary loop (see `boundary_loops`)
/// @cite liepa2003
HolePatch fill_with_membrane(const TriangleMesh& mesh, const std::vector<std::uint32_t>& loop);

}  // namespace clast::reconstruct_detail
