#pragma once
/// Shapes with known sizes, and random ones, for tests.
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Volume enclosed by a closed mesh, as a sum of signed tetrahedra about its first vertex.
inline double enclosed_volume(const TriangleMesh& mesh) {
  double sixfold = 0.0;
  const Vec3 origin = mesh.vertices.empty() ? Vec3(Vec3::Zero()) : mesh.vertices[0];
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    sixfold += (mesh.vertices[t[0]] - origin)
                   .dot((mesh.vertices[t[1]] - origin).cross(mesh.vertices[t[2]] - origin));
  }
  return sixfold / 6.0;
}

/// Two cones of height 1 on a circle of radius 1: fans of `around` triangles at both tips, which
/// are vertices 0 and 1.
inline TriangleMesh spindle(std::uint32_t around) {
  TriangleMesh mesh;
  mesh.vertices = {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0)};
  for (std::uint32_t i = 0; i < around; ++i) {
    const double turn = 2.0 * kPi * i / around;
    mesh.vertices.emplace_back(std::cos(turn), std::sin(turn), 0.0);
    const std::uint32_t here = 2 + i, next = 2 + (i + 1) % around;
    mesh.triangles.push_back({0, here, next});
    mesh.triangles.push_back({1, next, here});
  }
  return mesh;
}

/// A box from the origin to `sides`, every face a grid of `n` x `n` cells of two triangles.
inline TriangleMesh box_mesh(const Vec3& sides, int n = 1) {
  TriangleMesh mesh;
  std::vector<std::uint32_t> index((n + 1) * (n + 1) * (n + 1), 0xffffffffu);
  const auto at = [&](const std::array<int, 3>& g) {
    std::uint32_t& i = index[(g[0] * (n + 1) + g[1]) * (n + 1) + g[2]];
    if (i == 0xffffffffu) {
      i = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(Vec3(g[0], g[1], g[2]).cwiseProduct(sides) / n);
    }
    return i;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int end = 0; end < 2; ++end) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int du, int dv) {
            std::array<int, 3> g{};
            g[axis] = end * n;
            g[u] = i + du;
            g[v] = j + dv;
            return at(g);
          };
          const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1),
                              d = corner(0, 1);
          if (end == 1) {
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
          } else {
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({a, d, c});
          }
        }
      }
    }
  }
  return mesh;
}

inline TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return mesh;
}

/// The prism of height 1 over an outline that turns counter-clockwise and that `ends` cuts into
/// triangles.
inline TriangleMesh prism(const std::vector<Vec2>& outline,
                          const std::vector<TriangleMesh::Triangle>& ends) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (const double z : {0.0, 1.0}) {
    for (const Vec2& p : outline) mesh.vertices.push_back({p.x(), p.y(), z});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, j + n});
    mesh.triangles.push_back({i, j + n, i + n});
  }
  for (const auto& [a, b, c] : ends) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({a + n, b + n, c + n});
  }
  return mesh;
}

/// The 2 x 2 x 1 block with one quarter missing: one reflex edge.
inline TriangleMesh l_block() {
  return prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
               {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
}

/// Volume of the L-block with radius r <= 1.
inline double l_block_volume(double r) {
  return 3.0 + 14.0 * r + (21.0 * kPi / 4.0 - 1.0) * r * r +
         4.0 / 3.0 * (5.0 * kPi / 4.0 - 1.0) * r * r * r;
}

/// A block of 3 x 3 x 1 with a square hole through its middle.
inline TriangleMesh frame() {
  TriangleMesh mesh;
  const std::vector<Vec2> corners = {{0, 0}, {3, 0}, {3, 3}, {0, 3},
                                     {1, 1}, {2, 1}, {2, 2}, {1, 2}};
  for (const double z : {0.0, 1.0}) {
    for (const Vec2& p : corners) mesh.vertices.push_back({p.x(), p.y(), z});
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t j = (i + 1) % 4;
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    };
    quad(i, j, j + 8, i + 8);            // outside
    quad(j + 4, i + 4, i + 12, j + 12);  // wall of the hole
    quad(i + 8, j + 8, j + 12, i + 12);  // top
    quad(j, i, i + 4, j + 4);            // bottom
  }
  return mesh;
}

/// Octahedron split `levels` times and pushed out to radius 1 + `noise` x (-1..1), star-shaped
/// about the origin. 4^levels x 8 triangles.
inline TriangleMesh random_rock(std::uint64_t seed, int levels = 3, double noise = 0.1) {
  TriangleMesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::vector<std::array<std::uint32_t, 3>> known;  // low, high, middle
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      for (const auto& k : known) {
        if (k[0] == std::min(a, b) && k[1] == std::max(a, b)) return k[2];
      }
      mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
      const auto index = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
      known.push_back({std::min(a, b), std::max(a, b), index});
      return index;
    };
    std::vector<TriangleMesh::Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  Random random(seed);
  const Vec3 axes(random.uniform(0.6, 1.4), random.uniform(0.6, 1.4), random.uniform(0.6, 1.4));
  for (Vec3& v : mesh.vertices) {
    v = (1.0 + noise * random.uniform(-1.0, 1.0)) * v.cwiseProduct(axes);
  }
  return mesh;
}

}  // namespace clast
