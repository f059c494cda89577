#pragma once
/// Thinning a closed mesh.
#include <cstddef>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// How a closed surface is simplified before it becomes a block.
struct SimplifyOptions {
  std::size_t target_vertices = 250;

  void check() const;  ///< throws InputError naming the field and its value
};

/// Edge collapse that keeps the volume (Lindstrom & Turk 1998), with bounded normal change. The
/// result is closed, crosses itself nowhere and has at most `target_vertices` vertices. A tunnel
/// that is too narrow for that is closed, if that changes the volume by less than 1 %. A mesh at or
/// below the target is returned as it is.
/// @param mesh  closed, 2-manifold, outward
/// @throws GeometryError  if the mesh is not closed, more than 500 triangles meet at a vertex, or
/// the
///                        simplified mesh crosses itself all the same; the message says how many
///                        vertices are enough, if that was found
/// @cite lindstrom1998
TriangleMesh simplify_mesh(const TriangleMesh& mesh, const SimplifyOptions& options = {});

}  // namespace clast
