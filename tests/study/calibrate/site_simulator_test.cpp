// Members of a calibration, simulated by the DEM.
#include "study/calibrate/site_simulator.hpp"

#include <numeric>
#include <set>

#include "study/calibrate/posterior.hpp"
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
    CampaignRunOptions options;
    options.replace = true;
    run_campaign(prepared(text), file, options);
    const CampaignResults results = read_results(file);
    ASSERT_EQ(member.size(), results.runs.size());
    std::size_t passed = 0;
    for (std::size_t i = 0; i < member.size(); ++i) {
      const RunRecord& run = results.runs[i];
      EXPECT_EQ(member[i].stop,
                results.frame.to_map(run.result.final_state.position).head<2>().eval());
      EXPECT_EQ(member[i].point, run.point);
      EXPECT_EQ(member[i].block, run.block);
      if (member[i].barriers[0].passed()) ++passed;
    }
    std::set<std::uint32_t> crossing;
    for (const Crossing& one : results.crossings) crossing.insert(one.run);
    EXPECT_EQ(passed, crossing.size());
    EXPECT_GT(passed, 0u);
  }
  inline static const std::vector<UnknownParameter> kFriction = {
      {"ground.slope.friction", 0.2, 0.6, false}};
};

TEST_F(SiteSimulation, MembersAreTheRunsOfTheCampaignWithTheirGround) {
  CalibrationDesign design;
  design.releases_per_member = 12;  // all that the campaign plans
  SiteMemberSimulator simulator(site(), kFriction, design);
  expect_runs_of(with("friction = 0.4", "friction = 0.25"), simulator.simulate(0, {0.25}, 2));
}

TEST_F(SiteSimulation, MembersDoNotDisturbEachOther) {
  CalibrationDesign design;
  design.releases_per_member = 5;
  SiteMemberSimulator one(site(), kFriction, design), other(site(), kFriction, design);
  one.simulate(0, {0.55}, 1);
  one.simulate(1, {0.25}, 1);
  const std::vector<ReleaseOutcome> a = one.simulate(2, {0.3}, 2), b = other.simulate(2, {0.3}, 1);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].stop, b[i].stop);
  EXPECT_EQ(one.description().blocks, (std::vector<std::string>{"cube", "slab"}));
  EXPECT_EQ(one.description().barriers, std::vector<std::string>{"foot"});
  EXPECT_EQ(one.description().mean_start, Vec2(-12.0, 0.0));
}

TEST_F(SiteSimulation, StartsFollowTheirUnknowns) {
  CalibrationDesign design;
  design.releases_per_member = 12;
  SiteMemberSimulator simulator(site(), {{"release.velocity_x_m_s", 0.0, 6.0, false}}, design);
  simulator.simulate(0, {5.0}, 2);
  expect_runs_of(with("orientations =", "velocity_m_s = [2.5, 0, 0]\norientations ="),
                 simulator.simulate(1, {2.5}, 2));
}

// Where no unknown is of the blocks they are drawn once: all members have the same.
TEST_F(SiteSimulation, DrawnBlocksAreThoseOfTheCampaign) {
  const std::string text =
      with("library = \"blocks.h5\"",
           "library = \"blocks.h5\"\ndraw = { count = 3, seed = 2, mass_kg = { log_normal = [300, "
           "0.3] } }");
  CalibrationDesign design;
  design.releases_per_member = 18;
  SiteMemberSimulator simulator(site(text), kFriction, design);
  EXPECT_EQ(simulator.description().blocks.size(), 3u);
  simulator.simulate(0, {0.55}, 2);
  expect_runs_of(replaced_once(text, "friction = 0.4", "friction = 0.25"),
                 simulator.simulate(1, {0.25}, 2));
}

TEST_F(SiteSimulation, ImpactsAndTimesAreThoseOfTheRuns) {
  CalibrationDesign design;
  design.releases_per_member = 12;
  const std::vector<ObservedMoment> moments = {{ObservedMoment::Kind::kImpact, 1.0},
                                               {ObservedMoment::Kind::kImpact, 1e6},
                                               {ObservedMoment::Kind::kTime, 0.1},
                                               {ObservedMoment::Kind::kTime, 1e4}};
  SiteMemberSimulator simulator(site(), kFriction, design, moments);
  EXPECT_EQ(simulator.description().moments, moments);
  const std::vector<ReleaseOutcome> member = simulator.simulate(0, {0.4}, 2);
  const std::filesystem::path file = *folder_ / "results.h5";
  CampaignRunOptions options;
  options.replace = true;
  run_campaign(prepared(campaign_text()), file, options);
  const CampaignResults results = read_results(file);
  std::size_t seen = 0;
  for (const Impact& impact : results.impacts) {
    if (impact.run != seen) continue;  // the first of each run
    const OutcomeAtMoment& at = member[seen++].moments[0];
    EXPECT_EQ(at.speed, impact.speed_after);
    EXPECT_EQ(at.depth, impact.depth);
    EXPECT_EQ(at.energy, impact.translational_after + impact.rotational_after);
  }
  EXPECT_EQ(seen, member.size());
  for (const ReleaseOutcome& outcome : member) {
    EXPECT_FALSE(outcome.moments[1].passed());
    EXPECT_NEAR(outcome.moments[2].speed, 0.981, 1e-9);  // it falls from rest
    EXPECT_EQ(outcome.moments[2].position, outcome.start);
    EXPECT_EQ(outcome.moments[3].position, outcome.stop);
  }
}

// Blocks hit as they happen to lie: the mean of 200 impacts tells the friction.
TEST_F(SiteSimulation, TheGroundIsFoundAgainFromImpactsAlone) {
  const std::vector<double> truth = {0.35};
  CalibrationStudy study;
  study.design.member_count = 16;
  study.design.releases_per_member = 64;
  study.design.draw_count = 500;
  study.unknowns = kFriction;
  study.sites = {site(replaced_once(with("max_time_s = 6", "max_time_s = 1.2"), "\"turns.txt\"",
                                    "{ random = 50, fresh = true }"))};
  const std::vector<ObservedMoment> moments = {{ObservedMoment::Kind::kImpact, 1.0}};
  SiteMemberSimulator simulator(study.sites[0], study.unknowns, study.design, moments);
  CalibrationRuns runs{{simulator.description()}, {{}}};
  std::uint32_t number = 0;
  for (const std::vector<double>& place : study.design.sobol_points(1)) {
    runs.outcomes[0].push_back(simulator.simulate(number++, study.values(place), 2));
  }
  Observation impacts;
  impacts.name = "impacts";
  impacts.moment = moments[0];
  impacts.releases = 200;
  impacts.statistics = {
      {SummaryStatistic::Kind::kMeanSpeed, 0.0, "mean_speed_m_s", 0.0, {}, 0.02},
      {SummaryStatistic::Kind::kMeanAngularSpeed, 0.0, "mean_spin_rad_s", 0.0, {}, 0.05}};
  CalibrationDesign all_runs = study.design;
  all_runs.releases_per_member = 200;
  const std::vector<ReleaseOutcome> field =
      SiteMemberSimulator(study.sites[0], study.unknowns, all_runs, moments)
          .simulate(number, truth, 2);
  const std::vector<SelectedOutcome> seen = select_outcomes(impacts, runs.sites[0], field);
  std::vector<std::size_t> all(seen.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (SummaryStatistic& statistic : impacts.statistics)
    statistic.observed = compute_statistic(statistic, seen, all);
  study.observations = {impacts};
  const CalibrationPosterior found = infer_posterior(study, runs, 2);
  EXPECT_LE(found.marginals[0].low, truth[0]);
  EXPECT_GE(found.marginals[0].high, truth[0]);
  EXPECT_LT(found.marginals[0].width, 0.8);
}

TEST_F(SiteSimulation, MoreReleasesThanPlannedAreRefused) {
  CalibrationDesign design;
  design.releases_per_member = 13;
  EXPECT_TRUE(
      contains(clast::refusal<InputError>([&] { SiteMemberSimulator(site(), kFriction, design); }),
               "plans 12 runs, fewer than the 13 releases of each member"));
}

}  // namespace
}  // namespace clast
