// Energy, speed and height against distance, of runs whose trajectories are known.
#include "study/compare/profiles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "study/compare/path_samples.hpp"
#include "tests/study/csv_reader.hpp"
#include "tests/study/table_csv.hpp"
#include "tests/study/thrown_runs.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TerrainSurface level() {
  TriangleMesh mesh;
  for (const Vec2& corner : {Vec2(-9, -9), Vec2(99, -9), Vec2(99, 9), Vec2(-9, 9)}) {
    mesh.vertices.emplace_back(corner.x(), corner.y(), 0.0);
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return TerrainSurface(mesh, {0, 0});
}

TEST(PathSamples, FollowTheParabolaBetweenFrames) {
  BlockSummary block;
  block.mass = 3.0;
  block.moments = Vec3(1.0, 1.0, 5.0);
  double last = -1.0;
  std::size_t count = 0;
  for_each_path_sample(thrown(0.5), block, level(), 0.2, [&](const PathSample& sample) {
    const double t = sample.position.x() / 10.0;
    EXPECT_NEAR(sample.height, 2.0 - 0.5 * kTestGravity * t * t, 1e-12);
    EXPECT_NEAR(sample.position.z(), sample.height, 1e-12);
    EXPECT_LE(sample.position.x() - last, last < 0.0 ? 1.0 : 0.2 + 1e-9);
    last = sample.position.x();
    ++count;
  });
  EXPECT_NEAR(last, 5.0, 1e-12);
  EXPECT_EQ(count, 1u + 2u * 13u);
  // At a frame the energy is exact: m v^2/2 and J w^2/2.
  double first = 0.0;
  for_each_path_sample(thrown(0.0), block, level(), 0.2,
                       [&](const PathSample& s) { first = s.energy; });
  EXPECT_NEAR(first, 0.5 * 3.0 * 100.0 + 0.5 * 5.0 * 4.0, 1e-12);
}

TEST(Profiles, CountEveryRunOncePerBinWithItsLargestValues) {
  const ScratchFolder folder;
  store_thrown(folder / "r.h5");
  const Comparison comparison = compared(read_results(folder / "r.h5"));
  const CsvTable table = read_csv(table_csv(comparison, "profiles"));
  // The longest runout is 20 m: bins of 0.5 m, the first run to x = 5 m, the second to 2.5 m.
  const std::size_t all = table.find("group", "all");
  EXPECT_EQ(table.number(all, "from_m"), 0.0);
  EXPECT_EQ(table.number(all, "to_m"), 0.5);
  EXPECT_EQ(table.rows[all].at("runs"), "2");
  EXPECT_EQ(table.rows[all + 6].at("runs"), "1");
  EXPECT_EQ(table.number(all + 6, "from_m"), 3.0);
  // Seen at x = 0 and 0.25 m; the ground falls by one in two.
  EXPECT_NEAR(table.number(all, "height_max_m"),
              2.0 - 0.5 * kTestGravity * 0.025 * 0.025 + 0.5 * 0.25, 1e-9);
  EXPECT_GE(table.number(all + 6, "speed_max_m_s"), 10.0);
  EXPECT_LE(table.number(all + 6, "speed_max_m_s"), std::hypot(10.0, kTestGravity * 0.35) + 0.01);
}

TEST(Profiles, AreEmptyWithoutTrajectories) {
  EXPECT_TRUE(compute_profiles(compared(hand_made_results())).empty());
}

TEST(Profiles, BarrierMeetsTheLeastEnergyBeyondThePeakWhereBlocksStillCome) {
  std::vector<ProfileBin> bins;
  const auto add = [&](std::size_t group, std::size_t runs, double energy) {
    ProfileBin bin;
    bin.group = group;
    bin.from = 2.0 * static_cast<double>(bins.size());
    bin.runs = runs;
    bin.energy.p95 = energy;
    bins.push_back(bin);
  };
  // A start from rest, a peak, a bench, a wall, and a foot that few reach.
  for (const double energy : {1.0, 20.0, 30.0, 9.0, 40.0, 25.0}) add(0, 10, energy);
  add(0, 4, 3.0);
  add(1, 10, 2.0);
  const ProfileBin* place = find_least_energy_bin(bins, 0, 10);
  ASSERT_NE(place, nullptr);
  EXPECT_EQ(place->from, 6.0);
  EXPECT_EQ(find_least_energy_bin(bins, 1, 10), nullptr) << "no peak is behind";
  EXPECT_EQ(find_least_energy_bin(bins, 0, 30), nullptr) << "fewer than half come by";
}

}  // namespace
}  // namespace clast
