/// Thirty damaged copies of each of three real rocks, at three intensities.
#include <gtest/gtest.h>

#include <iostream>

#include "core/parallel.hpp"
#include "mesh/self_intersection.hpp"
#include "reconstruct/scan.hpp"
#include "tests/reconstruct/damage_study.hpp"
#include "tests/shapes/shape_samples.hpp"
#include "tests/support/reference_data.hpp"

namespace clast {
namespace {

/// How the intensities compare with the damage that software leaves: 1 is that of a bad scan.
constexpr double kIntensities[] = {0.5, 1.0, 1.5};
constexpr std::uint64_t kSeeds = 30;

/// A box whose upper end is turned by half a turn: its walls pass through each other at one point.
TEST(DamagedShapes, AnHourglassIsWrappedAndKeepsItsVolume) {
  TriangleMesh hourglass = box_mesh({1, 1, 1});
  for (Vec3& v : hourglass.vertices) {
    if (v.z() > 0.0) v = Vec3(1.0 - v.x(), 1.0 - v.y(), v.z());
  }
  const RepairedMesh result = repair_mesh(hourglass);
  const MeshReport report = inspect_mesh(result.mesh);
  EXPECT_TRUE(report.is_closed() && report.is_oriented()) << report.summary();
  EXPECT_TRUE(find_self_intersections(result.mesh).empty());
  EXPECT_NEAR(enclosed_volume(result.mesh), 1.0 / 3.0, 1e-9);  // squares of side |1 - 2 z|
  ASSERT_TRUE(result.report.relative_wrap_excess);
  EXPECT_GT(*result.report.relative_wrap_excess, 0.0);
  EXPECT_LT(*result.report.relative_wrap_excess, 0.08);
  EXPECT_NE(describe_repairs(result.report).back().find("was wrapped anew"), std::string::npos);
}

class DamagedRealRocks : public testing::TestWithParam<const char*> {};

TEST_P(DamagedRealRocks, ComeBackWithTheirVolumeOrAreRefused) {
  const TriangleMesh rock = read_scan(test_data(std::string("meshes/") + GetParam() + ".stl")).mesh;
  std::size_t valid = 0;
  for (const double intensity : kIntensities) {
    std::vector<Trial> trials(kSeeds);
    parallel_for(kSeeds, 0, [&](std::size_t i) { trials[i] = mend_damaged(rock, intensity, i); });
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      const Trial& trial = trials[seed];
      SCOPED_TRACE("intensity " + std::to_string(intensity) + " seed " + std::to_string(seed));
      valid += trial.valid;
      if (!trial.refusal.empty()) continue;  // said, and counted
      EXPECT_TRUE(trial.valid) << "silently wrong";
      EXPECT_NEAR(trial.volume_error, 0.0, 2e-3);
      EXPECT_LE(trial.hausdorff, trial.largest_hole);
    }
    std::cout << table_line(std::string(GetParam()) + " x" + std::to_string(intensity).substr(0, 3),
                            trials)
              << "\n";
  }
  EXPECT_GE(valid, 0.99 * std::size(kIntensities) * kSeeds);
}

INSTANTIATE_TEST_SUITE_P(Rocks, DamagedRealRocks,
                         testing::Values("eesd_stone15", "eesd_stone18", "rockable_rock"));

}  // namespace
}  // namespace clast
