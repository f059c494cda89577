#pragma once
/// Bodies and grounds with known properties.
#include <cmath>
#include <ostream>

#include "core/random.hpp"
#include "dem/motion/rigid_body.hpp"
#include "dem/simulation/release.hpp"
#include "dem/surface/terrain_surface.hpp"

namespace clast {

/// In the names of tests.
inline void PrintTo(ContactWeighting weighting, std::ostream* out) { *out << name_of(weighting); }

inline RigidBody ball(double mass, double radius) {
  RigidBody body;
  body.shape.vertices = {Vec3::Zero()};
  body.shape.radius = radius;
  body.mass = mass;
  body.moments = Vec3::Constant(0.4 * mass * radius * radius);
  body.smallest_side = 2.0 * radius;
  return body;
}

/// A box of the given sides as a core with each face cut into `cuts` x `cuts` squares. Moments are
/// those of the sharp box.
inline RigidBody box(double mass, const Vec3& sides, double radius = 0.0, int cuts = 1) {
  TriangleMesh mesh;
  const auto vertex = [&](const Vec3& p) {
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      if ((mesh.vertices[v] - p).norm() < 1e-9) return v;
    }
    mesh.vertices.push_back(p);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const auto corner = [&](int i, int j) {
        Vec3 p;
        p[axis] = 0.5 * side * sides[axis];
        p[(axis + 1) % 3] = (static_cast<double>(i) / cuts - 0.5) * sides[(axis + 1) % 3];
        p[(axis + 2) % 3] = (static_cast<double>(j) / cuts - 0.5) * sides[(axis + 2) % 3];
        return vertex(p);
      };
      for (int i = 0; i < cuts; ++i) {
        for (int j = 0; j < cuts; ++j) {
          const std::uint32_t a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                              d = corner(i, j + 1);
          if (side > 0) {
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
  RigidBody body;
  body.shape = make_sphero_polyhedron(mesh, radius);
  body.mass = mass;
  const Vec3 squares = sides.cwiseProduct(sides);
  body.moments =
      mass / 12.0 *
      Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
  body.smallest_side = sides.minCoeff() + 2.0 * radius;
  return body;
}

/// Two triangles for each of cells x cells squares, whose corners are numbered row by row.
inline std::vector<TriangleMesh::Triangle> halved_squares(int cells) {
  std::vector<TriangleMesh::Triangle> triangles;
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (cells + 1) + i);
      const auto b = a + 1, c = a + static_cast<std::uint32_t>(cells) + 2, d = c - 1;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }
  return triangles;
}

/// A plane through the origin that falls by `slope` (rad) along +x, `half` wide to each side in
/// plan, as cells x cells squares of two triangles. Inner nodes are moved in the plane at random.
inline TriangleMesh plane_mesh(double half, int cells, double slope = 0.0, std::uint64_t seed = 1) {
  Random random(seed);
  TriangleMesh mesh;
  const double size = 2.0 * half / cells;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      double x = -half + i * size, y = -half + j * size;
      if (i > 0 && i < cells && j > 0 && j < cells) {
        x += random.uniform(-0.3, 0.3) * size;
        y += random.uniform(-0.3, 0.3) * size;
      }
      mesh.vertices.emplace_back(x, y, -std::tan(slope) * x);
    }
  }
  mesh.triangles = halved_squares(cells);
  return mesh;
}

inline TerrainSurface ground(TriangleMesh mesh) {
  std::vector<std::uint16_t> zones(mesh.triangles.size(), 0);
  return TerrainSurface(std::move(mesh), std::move(zones));
}

/// A rough slope: `cells` x `cells` squares of `size` m, falling by `slope` along +x, with normal
/// scatter of the nodes of `roughness` m.
inline TriangleMesh rough_slope(int cells, double size, double slope, double roughness,
                                std::uint64_t seed = 1) {
  TriangleMesh mesh = plane_mesh(0.5 * cells * size, cells, slope, seed);
  Random random(seed + 1);
  for (Vec3& vertex : mesh.vertices) vertex.z() += roughness * random.normal();
  return mesh;
}

/// Stiffness k_n = k_t with k_r for an arm of half a metre, and a step of `steps` per radian.
inline ReleaseSettings stiff_settings(const RigidBody& body, double stiffness,
                                      double steps = 40.0) {
  ReleaseSettings settings;
  settings.stiffness.normal = settings.stiffness.tangential = stiffness;
  settings.stiffness.rolling = 0.25 * stiffness * body.smallest_side * body.smallest_side;
  settings.stiffness.time_step = std::sqrt(body.mass / stiffness) / steps;
  return settings;
}

}  // namespace clast
