#pragma once
/// A concave rock of any vertex count, made from a subdivided icosahedron.
#include <array>
#include <cmath>

#include "core/random.hpp"
#include "mesh/geodesic_sphere.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// A rock of about the given half axes with bumps and hollows, from a few smooth waves.
inline TriangleMesh rock_mesh(int frequency, const Vec3& half_axes, std::uint64_t seed,
                              double bumps = 0.12) {
  Random random(seed);
  TriangleMesh mesh = geodesic_sphere(frequency);
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
