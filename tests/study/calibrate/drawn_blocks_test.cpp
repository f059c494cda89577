// Calibrations that find what blocks there were: laws and shares of [blocks] draw.
#include <algorithm>
#include <numeric>

#include "study/calibrate/posterior.hpp"
#include "study/calibrate/site_simulator.hpp"
#include "study/campaign/named_seed.hpp"
#include "study/simulate/block_choice.hpp"
#include "study/simulate/run_plan.hpp"
#include "tests/study/campaign_run.hpp"

namespace clast {
namespace {

using Shares = std::vector<std::pair<std::string, double>>;

TEST(DrawnShares, OtherClassesDivideWhatIsLeftAsBefore) {
  BlockSampling draw;
  draw.shares = {{"disc", 0.5}, {"spheroid", 0.2}, {"blade", 0.2}, {"rod", 0.1}};
  EXPECT_EQ(class_fractions(draw), draw.shares);
  draw.set_shares = {{"spheroid", 0.5}, {"rod", 0.15}};
  // 0.35 is left for disc and blade, 5 : 2.
  const Shares shares = class_fractions(draw);
  EXPECT_NEAR(shares[0].second, 0.25, 1e-15);
  EXPECT_EQ(shares[1].second, 0.5);
  EXPECT_NEAR(shares[2].second, 0.1, 1e-15);
  EXPECT_EQ(shares[3].second, 0.15);
}

TEST(DrawnShares, MoreThanAllOrTooLittleIsRefused) {
  BlockSampling draw;
  draw.shares = {{"compact", 0.5}, {"elongated", 0.5}};
  draw.set_shares = {{"compact", 1.0}};
  EXPECT_EQ(class_fractions(draw)[1].second, 0.0);
  draw.set_shares["elongated"] = 0.25;
  EXPECT_EQ(clast::refusal<InputError>([&] { class_fractions(draw); }),
            "the fractions of the classes that are set add up to 1.25, more than 1");
  draw.set_shares["compact"] = 0.5;
  EXPECT_EQ(
      clast::refusal<InputError>([&] { class_fractions(draw); }),
      "the fractions of the classes that are set add up to 0.75, and no other class makes up the "
      "rest");
}

class DrawnBlocks : public CampaignRun {
 protected:
  static std::string text(const std::string& draw) {
    std::string all = with("library = \"blocks.h5\"", "library = \"blocks.h5\"\ndraw = " + draw);
    all = replaced_once(all, "\"turns.txt\"", "{ random = 20, fresh = true }");
    return replaced_once(all, "[run]", "[run]\ndownslope = [1, 0]");
  }
  static CalibrationSite site(const std::string& text) {
    CalibrationSite made{"north", campaign(text)};
    made.campaign.trajectory_interval = 0.0;
    return made;
  }
  /// A study of one site whose members and field are simulated, and what is found.
  static CalibrationPosterior found_again(const std::string& text,
                                          const std::vector<UnknownParameter>& unknowns,
                                          const std::vector<double>& truth,
                                          Observation observation) {
    CalibrationStudy study;
    study.design.member_count = 16;
    study.design.releases_per_member = 64;
    study.design.draw_count = 500;
    study.unknowns = unknowns;
    study.sites = {site(text)};
    std::vector<ObservedMoment> moments;
    if (observation.moment) moments = {*observation.moment};
    SiteMemberSimulator simulator(study.sites[0], study.unknowns, study.design, moments);
    CalibrationRuns runs{{simulator.description()}, {{}}};
    std::uint32_t number = 0;
    for (const std::vector<double>& place : study.design.sobol_points(unknowns.size())) {
      runs.outcomes[0].push_back(simulator.simulate(number++, study.values(place), 2));
    }
    const std::vector<ReleaseOutcome> field = simulator.simulate(1000, truth, 2);
    const std::vector<SelectedOutcome> seen = select_outcomes(observation, runs.sites[0], field);
    std::vector<std::size_t> all(seen.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (SummaryStatistic& statistic : observation.statistics)
      statistic.observed = compute_statistic(statistic, seen, all);
    observation.releases = seen.size();
    study.observations = {observation};
    return infer_posterior(study, runs, 2);
  }
  static void expect_found(const MarginalPosterior& marginal, double truth) {
    EXPECT_LE(marginal.low, truth);
    EXPECT_GE(marginal.high, truth);
    EXPECT_LT(marginal.width, 0.7);
  }
  inline static const std::string kLogNormal =
      "{ count = 60, seed = 2, mass_kg = { log_normal = [300, 0.3] } }";
};

TEST_F(DrawnBlocks, RunsOfSomeNumbersAreThoseOfTheWholePlan) {
  std::string all = text("{ count = 3, seed = 2 }");
  all = replaced_once(
      all, "[release]\npoints = [[-12, -3, 9.5], [-12, 3, 9.5]]",
      "[[release]]\nname = \"high\"\norientations = \"turns.txt\"\npoints = [[-14, 0, "
      "12]]\n[[release]]\nname = \"low\"\npoints = [[-12, -3, 9.5], [-12, 3, 9.5]]");
  CampaignPlan plan = prepared(all);
  ASSERT_EQ(plan.runs.size(), 3u * (3 + 2 * 20));
  std::vector<std::uint32_t> numbers(plan.runs.size());
  std::iota(numbers.rbegin(), numbers.rend(), 0u);
  const std::vector<RunRecord> runs = study_detail::plan_selected_runs(plan, numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const RunRecord& whole = plan.runs[numbers[i]];
    EXPECT_EQ(runs[i].run, whole.run);
    EXPECT_EQ(runs[i].block, whole.block);
    EXPECT_EQ(runs[i].point, whole.point);
    EXPECT_EQ(runs[i].orientation, whole.orientation);
    EXPECT_EQ(runs[i].ground_set, whole.ground_set);
    EXPECT_EQ(runs[i].start.position, whole.start.position);
    EXPECT_EQ(runs[i].start.orientation.coeffs(), whole.start.orientation.coeffs());
  }
}

TEST_F(DrawnBlocks, EachMemberHasBlocksOfItsOwn) {
  const CalibrationSite north =
      site(text("{ count = 3, seed = 2, shares = { compact = 0.6, "
                "elongated = 0.4 }, mass_kg = { log_normal = [300, 0.3] "
                "} }"));
  CalibrationDesign design;
  design.releases_per_member = 120;  // all that the campaign plans
  SiteMemberSimulator simulator(north,
                                {{"blocks.mass_median_kg", 100.0, 900.0, true},
                                 {"blocks.mass_sigma", 0.1, 0.5, false},
                                 {"blocks.share.elongated", 0.1, 0.9, false}},
                                design);
  EXPECT_EQ(simulator.description().blocks, (std::vector<std::string>{"cube", "slab"}));
  EXPECT_EQ(simulator.description().shapes, (std::vector<std::string>{"compact", "elongated"}));
  simulator.simulate(0, {800.0, 0.2, 0.2}, 2);
  const std::vector<ReleaseOutcome> member = simulator.simulate(1, {500.0, 0.4, 0.7}, 2);
  Campaign same = north.campaign;
  BlockSampling& draw = *same.blocks.draw;
  draw.seed = study_detail::derive_seed(2, "member 1");
  draw.mass->first = 500.0;
  draw.mass->second = 0.4;
  draw.shares = {{"compact", 0.3}, {"elongated", 0.7}};
  const std::filesystem::path file = *folder_ / "results.h5";
  run_campaign(prepare_campaign(same), file, {.replace = true});
  const CampaignResults results = read_results(file);
  ASSERT_EQ(member.size(), results.runs.size());
  for (std::size_t i = 0; i < member.size(); ++i) {
    const RunRecord& run = results.runs[i];
    EXPECT_EQ(member[i].stop,
              results.frame.to_map(run.result.final_state.position).head<2>().eval());
    EXPECT_EQ(simulator.description().blocks[member[i].block],
              results.blocks[run.block].library_block());
  }
}

TEST_F(DrawnBlocks, MembersDoNotDisturbEachOther) {
  const CalibrationSite north = site(text(kLogNormal));
  const std::vector<UnknownParameter> unknowns = {{"blocks.mass_median_kg", 100.0, 900.0, true},
                                                  {"release.velocity_x_m_s", 0.0, 3.0, false}};
  CalibrationDesign design;
  design.releases_per_member = 10;
  SiteMemberSimulator one(north, unknowns, design), other(north, unknowns, design);
  one.simulate(0, {120.0, 2.0}, 1);
  one.simulate(1, {800.0, 1.0}, 1);
  const std::vector<ReleaseOutcome> a = one.simulate(2, {300.0, 0.5}, 2);
  const std::vector<ReleaseOutcome> b = other.simulate(2, {300.0, 0.5}, 1);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].stop, b[i].stop);
    EXPECT_EQ(a[i].block, b[i].block);
  }
}

// Speeds hardly depend on the mass, but energies are in proportion to it. No block comes to the
// flat.
TEST_F(DrawnBlocks, EnergiesTellTheMedianMassAndNotTheGroundFurtherDown) {
  Observation impacts;
  impacts.name = "impacts";
  impacts.moment = ObservedMoment{ObservedMoment::Kind::kImpact, 1.0};
  impacts.statistics = {{SummaryStatistic::Kind::kMeanEnergy, 0.0, "mean_energy_j", 0.0, {}, 1.0}};
  const CalibrationPosterior found = found_again(
      replaced_once(text(kLogNormal), "max_time_s = 6", "max_time_s = 1.2"),
      {{"blocks.mass_median_kg", 100.0, 900.0, true}, {"ground.flat.friction", 0.3, 0.9, false}},
      {420.0, 0.5}, impacts);
  expect_found(found.marginals[0], 420.0);
  EXPECT_TRUE(found.marginals[1].is_undetermined());
  EXPECT_NEAR(found.marginals[1].median, 0.6, 0.08);
}

// Drawn cubes and slabs stop at different places.
TEST_F(DrawnBlocks, StopsTellTheShareOfAClass) {
  Observation stops;
  stops.name = "stops";
  stops.statistics = {{SummaryStatistic::Kind::kMeanStopPosition, 0.0, "mean_place_m", 0.0, {}},
                      {SummaryStatistic::Kind::kStopDeviation, 0.0, "std_place_m", 0.0, {}}};
  const CalibrationPosterior found =
      found_again(text("{ count = 60, seed = 2, shares = { compact = 0.5, elongated = 0.5 } }"),
                  {{"blocks.share.elongated", 0.0, 1.0, false}}, {0.8}, stops);
  expect_found(found.marginals[0], 0.8);
}

TEST_F(DrawnBlocks, UnusualSizesAtTheUpperEndsAreRefused) {
  const CalibrationSite north = site(text(kLogNormal));
  const auto refused = [&](double high) {
    return clast::refusal<InputError>([&] {
      SiteMemberSimulator(north, {{"blocks.mass_median_kg", 100.0, high, true}},
                          CalibrationDesign());
    });
  };
  EXPECT_EQ(refused(900.0), "");
  EXPECT_TRUE(contains(refused(1e6), "a block is no longer than a tenth of the terrain"))
      << refused(1e6);
  EXPECT_TRUE(
      contains(refused(1e6), "drawn with masses at the upper ends of the ranges in [[unknown]]"));
}

}  // namespace
}  // namespace clast
