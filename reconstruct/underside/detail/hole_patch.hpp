#pragma once
/// Filling of a hole by a membrane, a smooth surface of nearly minimum area within the rim.
///
/// `fill_holes` (holes.hpp) continues the slope of the surface at the rim instead. That is more
/// probable for a small gap, but may change the volume by tens of per cent for a whole underside.
/// Volume bounds need a membrane, which adds nothing beyond the rim.
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
