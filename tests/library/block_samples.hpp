#pragma once
/// Blocks for tests, made without any other module's computation.
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

/// Every member set to something that is not its default; the numbers need not fit each other.
inline Block filled_block(const std::string& id) {
  Block block;
  block.id = id;
  block.source = {"scans/" + id + ".stl", std::string(64, 'a'), "units=mm up=y", "0.1.0"};
  block.surface = cuboid(3.0, 2.0, 1.0);
  block.body.vertices = cuboid(2.9, 1.9, 0.9).vertices;
  block.body.edges = {{0, 1}, {2, 3}};
  block.body.faces = {{0, 2, 3, 1}, {4, 5, 7}};
  block.body.radius = 0.05;
  block.density = 2500.0;
  block.mass = {6.0, 15000.0, {0.1, 0.2, 0.3}, Mat3::Identity() * 7.0, 1e-5};
  block.mass.inertia(0, 1) = block.mass.inertia(1, 0) = 1.0 / 3.0;
  block.area = 22.0;
  block.principal = {{1.0, 2.0, 3.0}, Quat(0.5, 0.5, -0.5, 0.5), true};
  block.box.centre = {0.01, 0.02, 0.03};
  block.box.axes = Eigen::AngleAxisd(0.3, Vec3::UnitZ()).toRotationMatrix();
  block.box.lengths = {3.0, 2.0, 1.0};
  block.deviation = {.hausdorff = 0.01,
                     .scan_to_body = 0.009,
                     .body_to_scan = 0.01,
                     .mean = 0.002,
                     .volume_relative = -1e-4,
                     .area_relative = -2e-3,
                     .moments_relative = 3e-3};
  block.from_core = true;
  block.unseen = UnseenPart{.lower_volume = 5.5,
                            .best_volume = 6.0,
                            .upper_volume = 7.0,
                            .invented_share = 0.2,
                            .axes = AxesRange{{3.0, 2.0, 0.9}, {3.1, 2.2, 1.2}},
                            .assumption = "the flanks go on"};
  block.warnings = {"first", "second, with é"};
  block.field = {"Authume", "north face", Axes{2.9, 2.1, 1.1}, 14900.0};
  return block;
}

}  // namespace clast
