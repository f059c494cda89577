#pragma once
/// What the tests of the commands share.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "core/text_file.hpp"
#include "mesh/triangle_mesh.hpp"
#include "shapes/convex_hull.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {

namespace fs = std::filesystem;

/// The hull of 400 points on an ellipsoid, with noise of 2 %.
inline TriangleMesh noisy_ellipsoid(std::uint64_t seed, const Vec3& axes) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i) {
    points.push_back((1.0 + 0.02 * random.normal()) * random.direction().cwiseProduct(axes));
  }
  return convex_hull(points);
}

/// Written by hand, so that these tests do not lean on the writer they run beside.
inline void write_obj(const fs::path& path, const TriangleMesh& mesh) {
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

inline std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
  return names;
}

/// A failed command: exit code, a message that begins as all do and names `item`, nothing written.
inline void expect_refused(const ScratchFolder& folder, const std::vector<std::string>& arguments,
                           int code, const std::string& item) {
  const std::set<std::string> before = names_in(folder.path());
  const ProgramRun run = run_clast(arguments, folder.path());
  EXPECT_EQ(run.exit_code, code) << run.err;
  EXPECT_TRUE(run.err.starts_with("clast: ")) << run.err;
  EXPECT_TRUE(contains(run.err, item)) << run.err;
  EXPECT_EQ(names_in(folder.path()), before);
}

}  // namespace clast
