#pragma once
/// Decimation of closed meshes.
#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace clast {

struct SimplifyOptions {
  std::size_t target_vertices = 250;

  void check() const;  ///< throws InputError naming the field and its value
};

/// Decimates a mesh by volume-preserving edge collapse (Lindstrom & Turk 1998) with bounded normal
/// change. The result is closed, without self-intersections, with at most `target_vertices`
/// vertices. Tunnels too narrow for that are closed, if the volume changes by less than 1 %. Meshes
/// at or below the target are unchanged.
/// @param mesh  closed, 2-manifold, outward
/// @throws GeometryError  if the mesh is not closed, more than 500 triangles meet at a vertex, or
///                        self-intersections remain; states a sufficient number of vertices, if
///                        found
/// @cite lindstrom1998
TriangleMesh simplify_mesh(const TriangleMesh& mesh, const SimplifyOptions& options = {});

}  // namespace clast
