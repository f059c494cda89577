// From the published STL files of the Authume quarry to compared runs: 4 blocks, 4 release points
// and one orientation on profile P2, through the program and the shipped campaign.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>

#include "core/files/text_file.hpp"
#include "library/block_library.hpp"
#include "study/results/results.hpp"
#include "tests/study/csv_reader.hpp"
#include "tests/study/results_equal.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/support/run_program.hpp"

namespace clast {
namespace {

/// `text` with one occurrence of `from` replaced; the campaign must still hold it.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class AuthumeChain : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    // Radii and masses: Table 1 of the paper, and the README of the sample campaigns.
    const std::vector<std::array<std::string, 3>> blocks = {{"SP1A", "0.027", "343.5"},
                                                            {"SP2A", "0.049", "1472.5"},
                                                            {"SP2B", "0.006", "1767.5"},
                                                            {"SP3A", "0.005", "514.0"}};
    for (const auto& [id, radius, mass] : blocks) {
      const std::string scan = test_data("authume/blocks/" + id + ".stl").string();
      const ProgramRun made = run_clast({"reconstruct", scan, "-o", path("authume.h5"), "--core",
                                         "--radius", radius, "--mass", mass});
      ASSERT_EQ(made.exit_code, 0) << made.err;
    }
    std::istringstream published(read_text_file(test_data("authume/drop/orientations.txt")));
    std::string header, first;
    std::getline(published, header);
    std::getline(published, first);
    write_text_file(path("one_orientation.txt"), header + "\n" + first + "\n");

    // The campaign names the data by this variable, as a user would set it.
    const auto data = std::filesystem::absolute(test_data("authume")).parent_path();
    ::setenv("CLAST_DATA", data.c_str(), 1);
    std::string campaign =
        read_text_file(std::string(CLAST_SOURCE_DIR) + "/samples/authume/campaign-p2.toml");
    campaign = with(campaign, "../../out/authume.h5", path("authume.h5"));
    campaign =
        with(campaign, "${CLAST_DATA}/authume/drop/orientations.txt", path("one_orientation.txt"));
    campaign = with(campaign, "max_time_s = 60", "max_time_s = 40");
    write_text_file(path("campaign.toml"), campaign);
    simulated_ = run_clast({"simulate", path("campaign.toml"), "-o", path("results.h5")});
    compared_ = run_clast({"compare", path("results.h5"), "-o", path("report")});
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string path(const std::string& name) { return *folder_ / name; }

  static ScratchFolder* folder_;
  static ProgramRun simulated_, compared_;
};

ScratchFolder* AuthumeChain::folder_ = nullptr;
ProgramRun AuthumeChain::simulated_, AuthumeChain::compared_;

TEST_F(AuthumeChain, EveryRunStopsOnTheGroundWithItsEnergyAccountedFor) {
  ASSERT_EQ(simulated_.exit_code, 0) << simulated_.err;
  const CampaignResults results = read_results(path("results.h5"));
  ASSERT_EQ(results.runs.size(), 16u);
  for (const RunRecord& run : results.runs) {
    EXPECT_NE(run.result.stop_reason, StopReason::kError) << run.result.message;
    EXPECT_FALSE(run.result.below_ground) << "run " << run.run;
    EXPECT_LT(run.result.energy.error, 0.005) << "run " << run.run;
    // `auto` keeps the fastest impact within a quarter of S.
    EXPECT_LT(run.result.max_penetration, 0.25 * results.blocks[run.block].axes.S);
  }
}

TEST_F(AuthumeChain, BlocksStartWhereThePublishedRunsDoAndFallFreely) {
  std::istringstream points(read_text_file(test_data("authume/drop/positions_P2.xyz")));
  const CampaignResults results = read_results(path("results.h5"));
  std::vector<Vec3> published;
  for (double x, y, z; points >> x >> y >> z;) published.emplace_back(x, -z, y);
  ASSERT_EQ(published.size(), 4u);
  for (const RunRecord& run : results.runs) {
    const Vec3 start = results.frame.to_map(run.start.position);
    EXPECT_LT((start - published[run.point]).norm(), 1e-9);
    // The lowest block starts with its centre 1.4 m above ground: 0.2 s are free for all.
    const Trajectory track = read_trajectory(path("results.h5"), run.run);
    for (std::size_t i = 0; i < track.time.size() && track.time[i] <= 0.2; ++i) {
      const double t = track.time[i];
      const Vec3 expected = run.start.position - Vec3(0.0, 0.0, 0.5 * 9.81 * t * t);
      EXPECT_LT((track.states[i].position - expected).norm(), 1e-9);
      EXPECT_NEAR(std::abs(track.states[i].orientation.dot(run.start.orientation)), 1.0, 1e-12);
    }
  }
}

TEST_F(AuthumeChain, OrientationsTurnTheBlockAsItsFileHoldsIt) {
  // In the file's frame, y up, the quaternion turns the vertices of the STL file.
  const BlockLibrary library = BlockLibrary::read(path("authume.h5"));
  const CampaignResults results = read_results(path("results.h5"));
  std::istringstream line(read_text_file(path("one_orientation.txt")));
  std::string header;
  std::getline(line, header);
  double w, x, y, z;
  line >> w >> x >> y >> z;
  const Quat in_file = Quat(w, x, y, z).normalized();
  for (const RunRecord& run : results.runs) {
    const Block& block = library.find_block(results.blocks[run.block].id);
    const Vec3 corner = block.body.vertices.front();
    const Vec3 turned = in_file * (corner - block.mass.centre);
    const Vec3 expected = run.start.position + Vec3(turned.x(), -turned.z(), turned.y());
    const Vec3 in_body = block.source_from_body().inverse() * corner;
    EXPECT_LT((run.start.world_from_body() * in_body - expected).norm(), 1e-9);
  }
}

// 98 % of the published runs on P2 pass x = 16.25: the slope above is steeper than friction holds.
TEST_F(AuthumeChain, AllBlocksPassTheFirstBarrier) {
  ASSERT_EQ(compared_.exit_code, 0) << compared_.err;
  std::set<std::string> passed;
  for (const auto& row : read_csv(read_text_file(path("report/crossings.csv"))).rows) {
    if (row.at("barrier") == "EC21" && row.at("direction") == "forward")
      passed.insert(row.at("run"));
  }
  EXPECT_GE(passed.size(), 15u);
  EXPECT_TRUE(std::filesystem::exists(path("report/report.html")));
}

// k_r of SP2A was a quarter of its own where SP3A was in the campaign, and its mean stop 8 m
// farther.
TEST_F(AuthumeChain, ABlockRunsAsItDoesAlone) {
  const std::string all = "select  = [\"SP1A\", \"SP2A\", \"SP2B\", \"SP3A\"]";
  write_text_file(path("alone.toml"),
                  with(read_text_file(path("campaign.toml")), all, "select = [\"SP2A\"]"));
  const ProgramRun run = run_clast({"simulate", path("alone.toml"), "-o", path("alone.h5")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const CampaignResults alone = read_results(path("alone.h5"));
  const CampaignResults together = read_results(path("results.h5"));
  ASSERT_EQ(alone.runs.size(), 4u);
  ASSERT_EQ(together.blocks[1].id, "SP2A");
  for (const RunRecord& own : alone.runs) {
    RunRecord other = together.runs[4 + own.run];
    expect_equal(read_trajectory(path("results.h5"), other.run),
                 read_trajectory(path("alone.h5"), own.run));
    EXPECT_EQ(other.block, 1u);
    other.run = own.run;
    other.block = own.block;
    expect_equal(other, own);
  }
}

}  // namespace
}  // namespace clast
