// Campaigns whose members have the ground of draws from a posterior.
#include <set>

#include "study/calibration/calibrate.hpp"
#include "tests/study/calibration/made_up_site.hpp"
#include "tests/study/campaign_run.hpp"

namespace clast {
namespace {

class PosteriorEnsemble : public CampaignRun {
 protected:
  static void write(const std::vector<std::string>& parameters) {
    MadeUpStudy made(16, 32, 3);
    made.study.unknowns = {{parameters[0], 0.3, 0.9, false}, {parameters[1], 0.05, 0.5, false}};
    const MadeUpSite site;
    made.add_site("slope", site);
    made.observe(0, site, {0.6, 0.2}, 24, true, 4);
    CalibrationSimulator simulator{made.runs.sites, {"made-up 00"}, {}};
    simulator.simulate = [&](std::size_t number, std::uint32_t member, const std::vector<double>&) {
      return made.runs.outcomes[number][member];
    };
    CalibrateOptions options;
    options.replace = true;
    calibrate_with(simulator, made.study, *folder_ / "posterior.h5", options);
  }
  static std::string with_posterior(const std::string& more = "") {
    return campaign_text() + "[ensemble]\nmembers = 40\nposterior = \"posterior.h5\"\n" + more;
  }
};

TEST_F(PosteriorEnsemble, MembersHaveTheGroundOfDifferentDraws) {
  write({"ground.slope.friction", "ground.flat.rolling_friction"});
  const PreparedCampaign plan = prepared(with_posterior());
  const PosteriorDraws posterior = read_posterior_draws(*folder_ / "posterior.h5");
  ASSERT_EQ(plan.header.ground_sets.size(), 40u);
  std::set<std::vector<double>> drawn(posterior.draws.begin(), posterior.draws.end()), taken;
  for (const GroundSet& set : plan.header.ground_sets) {
    const std::vector<double> own = {set.zones[0].friction, set.zones[1].rolling_friction};
    EXPECT_TRUE(drawn.contains(own));
    taken.insert(own);
    // What the posterior does not have is as the campaign says.
    EXPECT_EQ(set.zones[1].friction, 0.6);
    EXPECT_EQ(set.zones[0].rolling_friction, 0.1);
  }
  EXPECT_GT(taken.size(), 35u);  // few draws coincide
  EXPECT_TRUE(contains(plan.header.inputs.back(), "posterior.h5"));
  EXPECT_EQ(prepared(with_posterior()).header.ground_sets[7].zones[0].friction,
            plan.header.ground_sets[7].zones[0].friction);
}

TEST_F(PosteriorEnsemble, OtherParametersMayBeUncertainToo) {
  write({"ground.slope.friction", "ground.flat.rolling_friction"});
  const std::string text = replaced_once(with_posterior("design = \"sobol\"\n"), "friction = 0.6",
                                         "friction = { uniform = [0.5, 0.7] }");
  std::set<double> frictions;
  for (const GroundSet& set : prepared(text).header.ground_sets) {
    EXPECT_GE(set.zones[1].friction, 0.5);
    EXPECT_LT(set.zones[1].friction, 0.7);
    frictions.insert(set.zones[1].friction);
  }
  EXPECT_EQ(frictions.size(), 40u);
  EXPECT_EQ(prepared(with_posterior("design = \"sobol\"\n")).header.ground_sets.size(), 40u);
}

TEST_F(PosteriorEnsemble, WhatDoesNotFitIsRefused) {
  const auto refused = [&](const std::string& text) {
    return clast::refusal<Error>([&] { campaign(text); });
  };
  write({"ground.scree.friction", "ground.mud.rolling_friction"});
  EXPECT_TRUE(contains(refused(with_posterior()),
                       "posterior = \"posterior.h5\": has no parameter of this ground, but "
                       "ground.scree.friction, ground.mud.rolling_friction"));
  write({"ground.slope.friction", "release.height_m"});
  EXPECT_TRUE(
      contains(refused(with_posterior()),
               "was calibrated with release.height_m, which is no parameter of the ground"));
  write({"ground.slope.friction", "ground.flat.rolling_friction"});
  EXPECT_TRUE(contains(refused(replaced_once(with_posterior(), "= 40", "= 4000")),
                       "members = 4000: is more than the 1000 draws of the posterior"));
  EXPECT_TRUE(
      contains(refused(replaced_once(with_posterior(), "posterior.h5", "blocks.h5")), "blocks.h5"));
  EXPECT_TRUE(
      contains(refused(replaced_once(with_posterior(), "posterior.h5", "slope.stl")), "slope.stl"));
}

}  // namespace
}  // namespace clast
