// Campaigns whose members have the ground of draws from a posterior.
#include <algorithm>
#include <set>

#include "study/calibrate/calibrate.hpp"
#include "tests/study/calibrate/made_up_site.hpp"
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
    CalibrationBackend simulator{made.runs.sites, {"made-up 00"}, {}};
    simulator.simulate = [&](std::size_t number, std::uint32_t member, const std::vector<double>&) {
      return made.runs.outcomes[number][member];
    };
    CalibrationOptions options;
    options.replace = true;
    run_calibration_with(simulator, made.study, *folder_ / "posterior.h5", options);
  }
  static std::string with_posterior(const std::string& more = "") {
    return campaign_text() + "[ensemble]\nmembers = 40\nposterior = \"posterior.h5\"\n" + more;
  }
};

TEST_F(PosteriorEnsemble, MembersHaveTheGroundOfDifferentDraws) {
  write({"ground.slope.friction", "ground.flat.rolling_friction"});
  const CampaignPlan plan = prepared(with_posterior());
  const PosteriorDraws posterior = read_posterior_draws(*folder_ / "posterior.h5");
  ASSERT_EQ(plan.header.ground_sets.size(), 40u);
  std::set<std::vector<double>> drawn(posterior.draws.begin(), posterior.draws.end()), taken;
  for (const GroundParameterSet& set : plan.header.ground_sets) {
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

TEST_F(PosteriorEnsemble, MembersStartAndTouchAsTheirDrawsSay) {
  write({"release.velocity_x_m_s", "release.spin_y_rad_s"});
  Campaign campaign = this->campaign(with_posterior("take = \"release\"\n"));
  // As if a stiffness had been calibrated in place of the spin.
  PosteriorDraws& posterior = *campaign.ensemble.posterior;
  posterior.parameters[1] = "contact.rolling_stiffness_n_m_rad";
  for (std::vector<double>& draw : posterior.draws) draw[1] *= 1e6;
  const CampaignPlan plan = prepare_campaign(campaign);
  std::set<std::vector<double>> drawn(posterior.draws.begin(), posterior.draws.end()), taken;
  for (const RunRecord& run : plan.runs) {
    const std::vector<double> own = {run.start.velocity.x(), run.stiffness.rolling};
    EXPECT_TRUE(drawn.contains(own));
    taken.insert(own);
    EXPECT_EQ(run.start.velocity.y(), 0.0);
    EXPECT_EQ(plan.header.ground_sets[run.ground_set].zones[0].friction, 0.4);
  }
  EXPECT_GT(taken.size(), 35u);
}

TEST_F(PosteriorEnsemble, HeightsAboveTheGroundAreThoseOfTheDraws) {
  write({"ground.slope.friction", "release.height_m"});
  const PosteriorDraws posterior = read_posterior_draws(*folder_ / "posterior.h5");
  const auto taking = [](const std::string& take) {
    return replaced_once(with_posterior("take = " + take + "\n"), "[release]\n",
                         "[release]\nheight_m = 2\n");
  };
  const CampaignPlan plan = prepared(taking("[\"ground\", \"release\"]"));
  const CampaignPlan ground = prepared(taking("\"ground\""));
  ASSERT_EQ(plan.runs.size(), ground.runs.size());
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const RunRecord& run = plan.runs[i];
    const double friction = plan.header.ground_sets[run.ground_set].zones[0].friction;
    const auto draw = std::find_if(posterior.draws.begin(), posterior.draws.end(),
                                   [&](const auto& one) { return one[0] == friction; });
    ASSERT_NE(draw, posterior.draws.end());
    // The campaign's own height is not used; the ground is that of the same draw.
    EXPECT_NEAR(run.start.position.z() - ground.runs[i].start.position.z(), (*draw)[1] - 2.0,
                1e-12);
    EXPECT_EQ(ground.header.ground_sets[ground.runs[i].ground_set].zones[0].friction, friction);
  }
  EXPECT_TRUE(
      contains(clast::refusal<Error>([&] { campaign(with_posterior("take = \"release\"\n")); }),
               "the posterior has release.height_m, but a release of this campaign has fixed start "
               "heights"));
}

TEST_F(PosteriorEnsemble, OtherParametersMayBeUncertainToo) {
  write({"ground.slope.friction", "ground.flat.rolling_friction"});
  const std::string text = replaced_once(with_posterior("design = \"sobol\"\n"), "friction = 0.6",
                                         "friction = { uniform = [0.5, 0.7] }");
  std::set<double> frictions;
  for (const GroundParameterSet& set : prepared(text).header.ground_sets) {
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
  EXPECT_TRUE(contains(refused(with_posterior()),
                       "was calibrated with release.height_m too; name the tables whose parameters "
                       "come from it: take = [\"ground\", \"release\"], or fewer"));
  write({"ground.slope.friction", "blocks.mass_median_kg"});
  EXPECT_TRUE(contains(refused(with_posterior()),
                       "was calibrated with blocks.mass_median_kg too; name the tables whose "
                       "parameters come from it: take = [\"ground\"], or fewer"));
  EXPECT_EQ(refused(with_posterior("take = \"ground\"\n")), "");
  EXPECT_TRUE(contains(refused(with_posterior("take = [\"ground\", \"blocks\"]\n")),
                       "\"blocks\"]: members of an ensemble have the same blocks; write the "
                       "calibrated values into [blocks] draw, and leave \"blocks\" out"));
  write({"blocks.mass_sigma", "blocks.mass_median_kg"});
  EXPECT_TRUE(contains(refused(with_posterior()),
                       "has blocks.mass_sigma, blocks.mass_median_kg alone, and members of an "
                       "ensemble have the same blocks"));
  write({"ground.slope.friction", "release.height_m"});
  EXPECT_TRUE(contains(refused(with_posterior("take = \"start\"\n")),
                       "take = \"start\": \"start\" is none of ground, contact, release"));
  EXPECT_TRUE(contains(refused(with_posterior("take = [\"ground\", \"contact\"]\n")),
                       "the posterior has no parameter of \"contact\", but ground.slope.friction"));
  EXPECT_TRUE(contains(refused(campaign_text() + "[ensemble]\nmembers = 4\ntake = \"ground\"\n"),
                       "no ground parameter is uncertain"));
  write({"ground.slope.friction", "ground.flat.rolling_friction"});
  EXPECT_TRUE(contains(refused(replaced_once(with_posterior(), "= 40", "= 4000")),
                       "members = 4000: exceeds the 1000 draws of the posterior"));
  EXPECT_TRUE(
      contains(refused(replaced_once(with_posterior(), "posterior.h5", "blocks.h5")), "blocks.h5"));
  EXPECT_TRUE(
      contains(refused(replaced_once(with_posterior(), "posterior.h5", "slope.stl")), "slope.stl"));
}

}  // namespace
}  // namespace clast
