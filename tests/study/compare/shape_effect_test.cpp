// A cube and a 2:1:1 prism of equal mass on a plane slope between rolling resistance and friction:
// what the comparison says of real runs is what their table says.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/files/text_file.hpp"
#include "library/block_library.hpp"
#include "library/make_block.hpp"
#include "study/compare/comparison.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/library/core_library.hpp"
#include "tests/study/csv_reader.hpp"
#include "tests/study/table_csv.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

// z = -x/2 from x = 0 to 40 m, then level to 90 m.
void write_slope(const std::filesystem::path& folder) {
  write_text_file(folder / "slope.obj",
                  "v 0 -30 20\nv 40 -30 0\nv 40 30 0\nv 0 30 20\nf 1 2 3\nf 1 3 4\n");
  write_text_file(folder / "flat.obj",
                  "v 40 -30 0\nv 90 -30 0\nv 90 30 0\nv 40 30 0\nf 1 2 3\nf 1 3 4\n");
}

void write_blocks(const std::filesystem::path& file) {
  write_core_library(file, {{"cube", cuboid(0.8, 0.8, 0.8)}, {"prism", cuboid(1.4, 0.7, 0.7)}});
}

// tan of the slope 0.5 lies between mu_R = 0.2 and mu = 0.7.
const std::string kCampaign = R"([blocks]
library = "blocks.h5"
scale = "equal-mass"
[terrain]
surface = ["slope.obj", "flat.obj"]
zones = ["slope", "flat"]
[ground.slope]
energy_restitution = 0.05
friction = 0.7
rolling_friction = 0.2
[ground.flat]
energy_restitution = 0.05
friction = 0.7
rolling_friction = 0.3
[release]
points = [[3, -6], [3, -2], [3, 2], [3, 6]]
height_m = 1.0
orientations = { random = 8, seed = 11 }
[run]
max_time_s = 30
downslope = [1, 0]
trajectory_interval_s = 0
)";

TEST(ShapeEffect, OfACubeAndAPrismIsWhatTheTableOfRunsSays) {
  const ScratchFolder folder;
  write_slope(folder.path());
  write_blocks(folder / "blocks.h5");
  write_text_file(folder / "campaign.toml", kCampaign);
  run_campaign(prepare_campaign(read_campaign(folder / "campaign.toml")), folder / "r.h5");
  std::vector<CampaignResults> results;
  results.push_back(read_results(folder / "r.h5"));
  const Comparison comparison = compare(std::move(results));

  bool geometry = false;
  for (const std::string& warning : comparison.warnings) {
    geometry = geometry || warning.find(
                               "zone slope slopes 26.6 deg on average, between atan mu_R "
                               "= 11.3 deg and atan mu = 35 deg") != std::string::npos;
    EXPECT_EQ(warning.find("mass differs"), std::string::npos) << warning;
  }
  EXPECT_TRUE(geometry);

  const CsvTable runs = read_csv(table_csv(comparison, "runs"));
  ASSERT_EQ(runs.rows.size(), 64u);
  std::map<std::string, std::vector<double>> runouts;
  for (std::size_t i = 0; i < runs.rows.size(); ++i) {
    EXPECT_EQ(runs.rows[i].at("below_ground"), "0");
    EXPECT_NEAR(runs.number(i, "mass_kg"), runs.number(0, "mass_kg"), 1e-6);
    if (runs.rows[i].at("stop_reason") != "rest") continue;
    runouts[runs.rows[i].at("shape")].push_back(runs.number(i, "stop_x_m") -
                                                runs.number(i, "start_x_m"));
  }
  const std::vector<double>&a = runouts.at("compact"), &b = runouts.at("elongated");
  double mean_a = 0.0, mean_b = 0.0, balance = 0.0;
  for (const double x : a) mean_a += x / static_cast<double>(a.size());
  for (const double y : b) mean_b += y / static_cast<double>(b.size());
  for (const double x : a) {
    for (const double y : b) balance += x > y ? 1.0 : x < y ? -1.0 : 0.0;
  }
  bool compared = false;
  for (const GroupDifference& one : comparison.differences) {
    if (comparison.groups[one.first].kind != RunGroupKind::kGarcia || one.quantity != "runout_m") {
      continue;
    }
    compared = true;
    EXPECT_EQ(one.first_runs, a.size());
    EXPECT_EQ(one.second_runs, b.size());
    EXPECT_EQ(one.points, 4u);
    EXPECT_NEAR(one.first_mean, mean_a, 1e-9);
    EXPECT_NEAR(one.second_mean, mean_b, 1e-9);
    EXPECT_NEAR(one.cliffs_delta, balance / static_cast<double>(a.size() * b.size()), 1e-12);
    ASSERT_TRUE(one.interval);
    EXPECT_LT(one.interval->low, mean_a - mean_b);
    EXPECT_GT(one.interval->high, mean_a - mean_b);
  }
  EXPECT_TRUE(compared);
}

}  // namespace
}  // namespace clast
