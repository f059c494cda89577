#pragma once
/// Blocks for tests, made without any other module's computation.
#include "core/types.hpp"
#include "library/block.hpp"

namespace clast {

/// A closed, outward cuboid around the origin.
inline TriangleMesh cuboid(double x, double y, double z) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back(i & 1 ? x / 2 : -x / 2, i & 2 ? y / 2 : -y / 2,
                               i & 4 ? z / 2 : -z / 2);
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Every member set to something that is not its default. Readers check what numbers say of each
/// other, so those of the body are of a rounded cuboid, by the formulas for that.
inline Block filled_block(const std::string& id) {
  Block block;
  block.id = id;
  block.source = {"scans/" + id + ".stl", std::string(64, 'a'), "units=mm up=y", "0.1.0"};
  block.surface = cuboid(3.0, 2.0, 1.0);
  const double a = 2.9, b = 1.9, c = 0.9, r = 0.05;
  block.body.vertices = cuboid(a, b, c).vertices;
  block.body.edges = {{0, 1}, {0, 2}, {0, 4}, {1, 3}, {1, 5}, {2, 3},
                      {2, 6}, {3, 7}, {4, 5}, {4, 6}, {5, 7}, {6, 7}};
  block.body.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                      {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  block.body.radius = r;
  block.density = 2500.0;
  block.mass.volume = a * b * c + 2.0 * r * (a * b + b * c + c * a) + kPi * r * r * (a + b + c) +
                      4.0 / 3.0 * kPi * r * r * r;
  block.mass.mass = 2500.0 * block.mass.volume;
  block.mass.centre = {0.1, 0.2, 0.3};
  block.mass.relative_error = 1e-5;
  block.area = 22.0;
  block.principal = {{1.0, 2.0, 2.5}, Quat(0.5, 0.5, -0.5, 0.5), true};
  const Mat3 turn = block.principal.rotation.toRotationMatrix();
  block.mass.inertia = turn * block.principal.moments.asDiagonal() * turn.transpose();
  block.box.centre = {0.01, 0.02, 0.03};
  for (Vec3& vertex : block.body.vertices) vertex += block.box.centre;
  block.box.axes = -Mat3::Identity();
  block.box.axes(2, 2) = 1.0;
  block.box.lengths = {3.0, 2.0, 1.0};
  block.deviation = {.hausdorff = 0.01,
                     .scan_to_body = 0.009,
                     .body_to_scan = 0.01,
                     .mean = 0.002,
                     .volume_relative = -1e-4,
                     .area_relative = -2e-3,
                     .moments_relative = 3e-3};
  block.from_core = true;
  block.volume_bracket = VolumeBracket{.lower_volume = 5.5,
                                       .estimated_volume = 6.0,
                                       .upper_volume = 7.0,
                                       .sides = BoxSideBounds{{3.0, 2.0, 0.9}, {3.1, 2.2, 1.2}},
                                       .filled_fraction = 0.2,
                                       .assumption = "the flanks go on"};
  block.warnings = {"first", "second, with é"};
  block.field = {"Authume", "north face", Axes{2.9, 2.1, 1.1}, 14900.0};
  return block;
}

}  // namespace clast
