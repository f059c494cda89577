#pragma once
/// The smallest concave body with an exact rounded volume.
#include <vector>

#include "shapes/triangle_mesh.hpp"

namespace clast {

/// L-shaped prism, 2 x 2 x 1 with a unit cube missing: one reflex edge.
inline TriangleMesh l_block() {
  TriangleMesh mesh;
  const std::vector<Vec2> outline = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const double z : {0.0, 1.0}) {
    for (const Vec2& p : outline) mesh.vertices.emplace_back(p.x(), p.y(), z);
  }
  for (std::uint32_t i = 1; i + 1 < 6; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({6, 6 + i, 7 + i});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, j + 6});
    mesh.triangles.push_back({i, j + 6, i + 6});
  }
  return mesh;
}

/// Of the rounded L, for r <= 1.
inline double l_block_volume(double r) {
  return 3.0 + 14.0 * r + (21.0 * kPi / 4.0 - 1.0) * r * r +
         4.0 / 3.0 * (5.0 * kPi / 4.0 - 1.0) * r * r * r;
}

}  // namespace clast
