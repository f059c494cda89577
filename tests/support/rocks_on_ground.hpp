#pragma once
/// A level ground with two rocks on it.
#include "tests/support/scan_files.hpp"

namespace clast {

/// A level square of so many cells a side.
inline TriangleMesh level_grid(std::uint32_t cells, double half) {
  TriangleMesh mesh;
  const double step = 2.0 * half / cells;
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i) {
      mesh.vertices.emplace_back(step * i - half, step * j - half, 0.0);
    }
  }
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = (cells + 1) * j + i;
      mesh.triangles.push_back({a, a + 1, a + cells + 2});
      mesh.triangles.push_back({a, a + cells + 2, a + cells + 1});
    }
  }
  return mesh;
}

/// A square of 6 m with a rock of about 1.2 x 1 x 0.8 m at x = 1.5 m and one at x = -1.4 m.
inline TriangleMesh two_rocks_on_ground() {
  TriangleMesh scene = level_grid(60, 3.0);
  for (const double x : {1.5, -1.4}) {
    TriangleMesh rock = noisy_ellipsoid(x > 0 ? 5 : 6, {0.6, 0.5, 0.4});
    for (Vec3& v : rock.vertices) v += Vec3(x, 0.2, 0.3);
    scene = merged(std::move(scene), rock);
  }
  return scene;
}

}  // namespace clast
