#pragma once
/// A concave rock of any vertex count, made from a subdivided icosahedron.
#include <array>
#include <cmath>
#include <map>

#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Sphere of radius 1 from an icosahedron, each edge cut into `frequency` parts: 10 frequency^2 + 2
/// vertices.
inline TriangleMesh unit_sphere(int frequency) {
  const double t = 0.5 * (1.0 + std::sqrt(5.0));
  const std::array<Vec3, 12> corners = {Vec3(-1, t, 0),  Vec3(1, t, 0),   Vec3(-1, -t, 0),
                                        Vec3(1, -t, 0),  Vec3(0, -1, t),  Vec3(0, 1, t),
                                        Vec3(0, -1, -t), Vec3(0, 1, -t),  Vec3(t, 0, -1),
                                        Vec3(t, 0, 1),   Vec3(-t, 0, -1), Vec3(-t, 0, 1)};
  const std::array<std::array<int, 3>, 20> faces = {
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  TriangleMesh mesh;
  std::map<std::array<long, 3>, std::uint32_t> known;
  const auto vertex = [&](const Vec3& p) {
    const Vec3 unit = p.normalized();
    const std::array<long, 3> key = {std::lround(unit.x() * 1e7), std::lround(unit.y() * 1e7),
                                     std::lround(unit.z() * 1e7)};
    const auto [it, fresh] =
        known.try_emplace(key, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (fresh) mesh.vertices.push_back(unit);
    return it->second;
  };
  for (const auto& face : faces) {
    const auto at = [&](int i, int j) {
      const double a = static_cast<double>(i) / frequency, b = static_cast<double>(j) / frequency;
      return vertex((1.0 - a - b) * corners[face[0]] + a * corners[face[1]] + b * corners[face[2]]);
    };
    for (int i = 0; i < frequency; ++i) {
      for (int j = 0; i + j < frequency; ++j) {
        mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < frequency) {
          mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
      }
    }
  }
  return mesh;
}

/// A rock of about the given half axes with bumps and hollows, from a few smooth waves.
inline TriangleMesh rock_mesh(int frequency, const Vec3& half_axes, std::uint64_t seed,
                              double bumps = 0.12) {
  Random random(seed);
  TriangleMesh mesh = unit_sphere(frequency);
  std::array<Vec3, 6> waves;
  std::array<double, 6> phases;
  for (int i = 0; i < 6; ++i) {
    waves[i] = random.uniform(2.0, 5.0) * random.unit_vector();
    phases[i] = random.uniform(0.0, 2.0 * kPi);
  }
  for (Vec3& vertex : mesh.vertices) {
    double radius = 1.0;
    for (int i = 0; i < 6; ++i) radius += bumps / 2.0 * std::sin(waves[i].dot(vertex) + phases[i]);
    vertex = radius * vertex.cwiseProduct(half_axes);
  }
  return mesh;
}

/// The same with the grain of a scanned surface: every vertex moved along its radius by a normal
/// scatter of `grain` times the mean edge length.
inline TriangleMesh rough_rock_mesh(int frequency, const Vec3& half_axes, std::uint64_t seed,
                                    double grain) {
  TriangleMesh mesh = rock_mesh(frequency, half_axes, seed);
  Random random(seed + 1);
  const double edge = 1.1 / frequency;  // of the unit sphere: 63 degrees in `frequency` parts
  for (Vec3& vertex : mesh.vertices) vertex *= 1.0 + grain * edge * random.normal();
  return mesh;
}

}  // namespace clast
