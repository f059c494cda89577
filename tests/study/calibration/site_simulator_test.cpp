// Members of a calibration, simulated by the DEM.
#include "study/calibration/site_simulator.hpp"

#include <set>

#include "tests/study/campaign_run.hpp"

namespace clast {
namespace {

class SiteSimulation : public CampaignRun {
 protected:
  static CalibrationSite site(const std::string& text = campaign_text()) {
    CalibrationSite made{"north",
                         campaign(replaced_once(text, "[run]", "[run]\ndownslope = [1, 0]"))};
    made.campaign.trajectory_interval = 0.0;
    return made;
  }
  /// That a member is the runs of this campaign.
  static void expect_runs_of(const std::string& text, const std::vector<ReleaseOutcome>& member) {
    const std::filesystem::path file = *folder_ / "results.h5";
    RunOptions options;
    options.replace = true;
    run_campaign(prepared(text), file, options);
    const CampaignResults results = read_results(file);
    ASSERT_EQ(member.size(), results.runs.size());
    std::size_t passed = 0;
    for (std::size_t i = 0; i < member.size(); ++i) {
      const RunRecord& run = results.runs[i];
      EXPECT_EQ(member[i].stop,
                results.frame.map(run.result.final_state.position).head<2>().eval());
      EXPECT_EQ(member[i].point, run.point);
      EXPECT_EQ(member[i].block, run.block);
      if (member[i].barriers[0].passed()) ++passed;
    }
    std::set<std::uint32_t> crossing;
    for (const Crossing& one : results.crossings) crossing.insert(one.run);
    EXPECT_EQ(passed, crossing.size());
    EXPECT_GT(passed, 0u);
  }
  inline static const std::vector<Unknown> kFriction = {{"ground.slope.friction", 0.2, 0.6, false}};
};

TEST_F(SiteSimulation, MembersAreTheRunsOfTheCampaignWithTheirGround) {
  CalibrationDesign design;
  design.releases = 12;  // all that the campaign plans
  SiteSimulator simulator(site(), kFriction, design);
  expect_runs_of(with("friction = 0.4", "friction = 0.25"), simulator.simulate(0, {0.25}, 2));
}

TEST_F(SiteSimulation, MembersDoNotDisturbEachOther) {
  CalibrationDesign design;
  design.releases = 5;
  SiteSimulator one(site(), kFriction, design), other(site(), kFriction, design);
  one.simulate(0, {0.55}, 1);
  one.simulate(1, {0.25}, 1);
  const std::vector<ReleaseOutcome> a = one.simulate(2, {0.3}, 2), b = other.simulate(2, {0.3}, 1);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].stop, b[i].stop);
  EXPECT_EQ(one.facts().blocks, (std::vector<std::string>{"cube", "slab"}));
  EXPECT_EQ(one.facts().barriers, std::vector<std::string>{"foot"});
  EXPECT_EQ(one.facts().middle_of_starts, Vec2(-12.0, 0.0));
}

TEST_F(SiteSimulation, StartsFollowTheirUnknowns) {
  CalibrationDesign design;
  design.releases = 12;
  SiteSimulator simulator(site(), {{"release.velocity_x_m_s", 0.0, 6.0, false}}, design);
  simulator.simulate(0, {5.0}, 2);
  expect_runs_of(with("orientations =", "velocity_m_s = [2.5, 0, 0]\norientations ="),
                 simulator.simulate(1, {2.5}, 2));
}

TEST_F(SiteSimulation, MoreReleasesThanPlannedAreRefused) {
  CalibrationDesign design;
  design.releases = 13;
  EXPECT_TRUE(
      contains(clast::refusal<InputError>([&] { SiteSimulator(site(), kFriction, design); }),
               "plans 12 runs, fewer than the 13 releases of each member"));
}

}  // namespace
}  // namespace clast
