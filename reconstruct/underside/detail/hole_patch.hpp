#pragma once
/// Filling one hole by a smooth skin of triangles as fine as its rim.
///
/// Not by `fill_holes` of holes.hpp, which fairs: its filling goes on as the rim leans, which is
/// the likeliest rock behind a gap, but of a whole underside it may bulge by tenths of the volume
/// either way. A bracket needs the opposite: a membrane that adds nothing beyond its rim (the lower
/// bound), with the shape by which it is then lowered.
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast::reconstruct_detail {

/// Triangles across a rim and the new vertices among them.
struct HolePatch {
  std::vector<Vec3> vertices;                     ///< new ones, numbered after those of the mesh
  std::vector<TriangleMesh::Triangle> triangles;  ///< turned like their neighbours
  /// Of each new vertex, 0..1: how far it bulges under even pressure; the largest is 1. A parabola
  /// over a round rim.
  std::vector<double> deflection;
};

/// Fills `loop` as a membrane does: triangulated, refined to the density of the rim, and every new
/// vertex in the mean of its neighbours (harmonic, weights of cotangents). Where no triangulation
/// is found, a star of triangles from the middle of the rim.
/// @param loop  as `boundary_loops` gives it
/// @cite liepa2003
HolePatch fill_with_membrane(const TriangleMesh& mesh, const std::vector<std::uint32_t>& loop);

}  // namespace clast::reconstruct_detail
