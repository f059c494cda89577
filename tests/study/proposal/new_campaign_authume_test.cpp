// A campaign proposed on the quarry of the paper, in its three zones.
#include <gtest/gtest.h>

#include "study/proposal/new_campaign.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "terrain/terrain_file.hpp"
#include "terrain/terrain_input.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/library/core_library.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(NewCampaignAuthume, RunsDownTheQuarry) {
  const ScratchFolder folder;
  TerrainOptions options;
  options.surface = {test_data("authume/terrain/DTM_Blue_zone.stl"),
                     test_data("authume/terrain/DTM_Gray_zone.stl"),
                     test_data("authume/terrain/DTM_Red_zone.stl")};
  options.zones = {"vegetated slope", "rock walls", "rocky slope"};
  options.up = "y";
  const Terrain terrain = read_terrain(options);
  write_terrain(folder / "quarry.h5", terrain);
  write_core_library(folder / "blocks.h5",
                     {{"cube", cuboid(0.8, 0.75, 0.7)}, {"bar", cuboid(1.6, 0.6, 0.5)}});
  const CampaignProposal proposal =
      write_new_campaign(folder / "blocks.h5", {folder / "quarry.h5"}, folder / "campaign.toml");
  EXPECT_TRUE(proposal.proposal_warnings.empty())
      << testing::PrintToString(proposal.proposal_warnings);
  ASSERT_EQ(proposal.ground.size(), 3u);
  for (const ProposedGround& zone : proposal.ground) {
    const bool wall = zone.zone == "rock walls", slope = zone.zone == "rocky slope";
    EXPECT_EQ(zone.type.name, wall ? "rock" : slope ? "talus" : "soil medium");
  }
  const Bounds box = bounds(terrain.surface);
  const double low = terrain.frame.to_map(box.low).z(), high = terrain.frame.to_map(box.high).z();
  EXPECT_GT(proposal.places.releases.from.z(), low + 0.5 * (high - low));
  EXPECT_GT(proposal.places.descent, 15.0);

  const std::string all = read_text_file(folder / "campaign.toml");
  const std::size_t at = all.find("random = "), end = all.find(',', at);
  write_text_file(folder / "few.toml", all.substr(0, at) + "random = 2" + all.substr(end));
  run_campaign(prepare_campaign(read_campaign(folder / "few.toml")), folder / "results.h5");
  const CampaignResults results = read_results(folder / "results.h5");
  std::size_t moved = 0;
  for (const RunRecord& run : results.runs) {
    moved += (run.result.final_state.position - run.start.position).head<2>().norm() > 5.0 ? 1 : 0;
  }
  EXPECT_GT(moved, results.runs.size() / 2);
}

}  // namespace
}  // namespace clast
