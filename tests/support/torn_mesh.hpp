#pragma once
/// Meshes that lost triangles or vertices at random.
#include <vector>

#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Without the share of the triangles, each drawn by itself.
inline TriangleMesh without_triangles(TriangleMesh mesh, double share, std::uint64_t seed) {
  Random random(seed);
  std::erase_if(mesh.triangles,
                [&](const TriangleMesh::Triangle&) { return random.uniform() < share; });
  return mesh;
}

/// Without the share of the vertices, and all triangles at them.
inline TriangleMesh without_vertices(TriangleMesh mesh, double share, std::uint64_t seed) {
  Random random(seed);
  std::vector<bool> gone(mesh.vertices.size());
  for (std::size_t v = 0; v < gone.size(); ++v) gone[v] = random.uniform() < share;
  std::erase_if(mesh.triangles, [&](const TriangleMesh::Triangle& t) {
    return gone[t[0]] || gone[t[1]] || gone[t[2]];
  });
  return mesh;
}

}  // namespace clast
