#pragma once
/// Decimation of closed meshes.
#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace clast {

struct SimplifyOptions {
  std::size_t target_vertices = 250;

  void check() const;  ///< throws InputError naming the field and its value
};

/// Decimates a mesh by volume-preserving edge collapse [lindstrom1998] with bounded normal change.
/// The result is closed, has no self-intersections and at most `target_vertices` vertices. Narrow
/// tunnels are closed if they prevent this and if the volume changes by less than 1 %. Meshes with
/// at most `target_vertices` vertices are unchanged.
/// @param mesh  closed, 2-manifold, outward
/// @throws GeometryError  if the mesh is not closed, more than 500 triangles meet at a vertex, or
///                        self-intersections remain; states a sufficient number of vertices if one
///                        was found
/// @cite lindstrom1998
TriangleMesh simplify_mesh(const TriangleMesh& mesh, const SimplifyOptions& options = {});

}  // namespace clast
