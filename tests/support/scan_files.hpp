#pragma once
/// Small scans as files.
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "mesh/triangle_mesh.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {

/// The hull of 400 points on an ellipsoid, with noise of 2 %.
inline TriangleMesh noisy_ellipsoid(std::uint64_t seed, const Vec3& axes) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i) {
    points.push_back((1.0 + 0.02 * random.normal()) * random.unit_vector().cwiseProduct(axes));
  }
  return convex_hull(points);
}

/// Written by hand, so that these tests do not lean on the writer they run beside.
inline void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh) {
  std::string text;
  char line[128];
  for (const Vec3& v : mesh.vertices) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", v.x(), v.y(), v.z());
    text += line;
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    std::snprintf(line, sizeof line, "f %u %u %u\n", a + 1, b + 1, c + 1);
    text += line;
  }
  write_text_file(path, text);
}

}  // namespace clast
