#include "study/calibrate/calibration_study.hpp"

#include "tests/study/campaign_file.hpp"
#include "tests/study/campaign_run.hpp"

namespace clast {
namespace {

const std::string kStudy = R"([design]
members = 16
releases = 8

[[site]]
name = "north"
campaign = "campaign.toml"

[[unknown]]
parameter = "ground.blue.friction"
range = [0.4, 0.9]

[[unknown]]
parameter = "contact.rolling_stiffness_n_m_rad"
range = [1e5, 1e7]
scale = "log"

[[observation]]
name = "stops"
use = "fit"
shape = "compact"
stops = "stops.csv"

[[observation]]
name = "passages"
use = "keep"
barrier = "EC11"
releases = 23
passed = 19
speed_m_s = [8.4, 0.5]
)";

class StudyFile : public CampaignFile {
 protected:
  StudyFile() {
    write_text_file(folder_ / "campaign.toml", kCampaign);
    write_text_file(folder_ / "stops.csv",
                    "x,y,shape\n10,0,compact\n20,0,compact\n40,0,compact\n5,0,elongated\n");
  }
  CalibrationStudy read_study(const std::string& text = kStudy) const {
    write_text_file(folder_ / "study.toml", text);
    return read_calibration_study(folder_ / "study.toml");
  }
  // The message without the folder.
  std::string refused(const std::string& from, const std::string& to) const {
    std::string text = kStudy;
    const std::size_t at = text.find(from);
    if (at == std::string::npos) return "the study has no " + from;
    text.replace(at, from.size(), to);
    try {
      read_study(text);
    } catch (const InputError& error) {
      std::string message = error.what();
      const std::string prefix = folder_.path().string() + "/";
      for (std::size_t place; (place = message.find(prefix)) != std::string::npos;) {
        message.erase(place, prefix.size());
      }
      return message;
    }
    return "";
  }
};

TEST_F(StudyFile, HoldsSitesUnknownsAndFigures) {
  const CalibrationStudy study = read_study();
  EXPECT_EQ(study.design.member_count, 16u);
  EXPECT_EQ(study.sites[0].name, "north");
  ASSERT_EQ(study.unknowns.size(), 2u);
  EXPECT_DOUBLE_EQ(study.unknowns[0].prior_quantile(0.5), 0.65);
  EXPECT_NEAR(study.unknowns[1].prior_quantile(0.5), 1e6, 1.0);
  EXPECT_DOUBLE_EQ(study.unknowns[1].probability_below(1e6), 0.5);
  ASSERT_EQ(study.observations.size(), 2u);
  // Release points (1, 2, 3) and (4, 5, 6) with y up lie at (1, -3) and (4, -6); downslope is
  // (1, 0.1)/sqrt(1.01). The three compact stops are 7.5, 17.5 and 37.5 beyond their middle in x.
  const Observation& stops = study.observations[0];
  EXPECT_TRUE(stops.fitted);
  EXPECT_EQ(stops.releases, 3u);
  const double mean = ((7.5 + 17.5 + 37.5) / 3.0 + 0.1 * 4.5) / std::sqrt(1.01);
  EXPECT_NEAR(stops.statistics[0].observed, mean, 1e-9);
  EXPECT_NEAR(
      stops.statistics[1].observed,
      std::sqrt((13.3333333 * 13.3333333 + 3.3333333 * 3.3333333 + 16.6666667 * 16.6666667) / 2.0) /
          std::sqrt(1.01),
      1e-6);
  const Observation& passages = study.observations[1];
  EXPECT_FALSE(passages.fitted);
  EXPECT_DOUBLE_EQ(passages.statistics[0].observed, 19.0 / 23.0);
  EXPECT_FALSE(passages.statistics[0].error);
  EXPECT_EQ(passages.statistics[1].name, "mean_speed_m_s");
  EXPECT_EQ(*passages.statistics[1].error, 0.5);
}

TEST_F(StudyFile, EveryKindOfUnknownIsSet) {
  Campaign campaign = read_study().sites[0].campaign;
  set_parameter(campaign, "ground.blue.friction", 0.55);
  set_parameter(campaign, "contact.stiffness_n_m", 2e7);
  set_parameter(campaign, "release.velocity_z_m_s", -1.5);
  set_parameter(campaign, "release.spin_x_rad_s", 3.0);
  EXPECT_EQ(campaign.ground.at("blue").friction->first, 0.55);
  EXPECT_EQ(*campaign.stiffness.normal, 2e7);
  EXPECT_EQ(campaign.releases[0].velocity, Vec3(1.0, 0.5, -1.5));
  EXPECT_EQ(campaign.releases[0].angular_velocity.x(), 3.0);
  EXPECT_FALSE(has_parameter(campaign, "release.height_m"));
  EXPECT_FALSE(has_parameter(campaign, "ground.green.friction"));
  EXPECT_TRUE(is_release_parameter("release.spin_x_rad_s"));
  EXPECT_FALSE(is_release_parameter("contact.stiffness_n_m"));
  EXPECT_STREQ(calibratable_range("contact.stiffness_n_m").unit, "N/m");
}

TEST_F(StudyFile, LawsAndSharesOfDrawnBlocksAreUnknowns) {
  const auto drawing = [&](const std::string& draw) {
    write_text_file(folder_ / "campaign.toml",
                    replaced_once(kCampaign, "select = [\"B1\", \"B2\"]", "draw = " + draw));
  };
  const auto asked = [&](const std::string& parameter, const std::string& range) {
    return refused(
        "parameter = \"contact.rolling_stiffness_n_m_rad\"\nrange = [1e5, "
        "1e7]\nscale = \"log\"",
        "parameter = \"" + parameter + "\"\nrange = " + range);
  };
  const std::string no_class = "no campaign has [blocks] draw with this class in shares";
  EXPECT_TRUE(contains(asked("blocks.mass_median_kg", "[100, 900]"),
                       "no campaign has [blocks] draw with mass_kg = { log_normal = [median, "
                       "sigma] }"));
  EXPECT_TRUE(contains(asked("blocks.share.compact", "[0, 1]"), no_class));
  drawing("{ count = 5, mass_kg = { log_normal = [300, 0.3] } }");
  EXPECT_EQ(asked("blocks.mass_median_kg", "[100, 900]"), "");
  EXPECT_EQ(asked("blocks.mass_sigma", "[0.1, 1]"), "");
  EXPECT_TRUE(contains(asked("blocks.mass_sigma", "[0, 9]"), "from 1e-09 to 5"));
  EXPECT_TRUE(contains(asked("blocks.mass_kg", "[100, 900]"), "draw with a number as mass_kg"));
  EXPECT_TRUE(contains(asked("blocks.mass_std_kg", "[100, 900]"), "{ normal = [mean, std] }"));
  EXPECT_TRUE(contains(asked("blocks.share.compact", "[0, 1]"), no_class));
  EXPECT_TRUE(contains(asked("blocks.share.round", "[0, 1]"),
                       "is not the fraction of a class; classes are compact, elongated"));
  drawing("{ count = 5, shares = { compact = 0.5, elongated = 0.5 }, mass_kg = 300 }");
  EXPECT_EQ(asked("blocks.mass_kg", "[100, 900]"), "");
  EXPECT_EQ(asked("blocks.share.compact", "[0, 1]"), "");
  EXPECT_TRUE(contains(asked("blocks.share.compact", "[0, 1.5]"), "1.5"));
  const std::string both =
      "[0, 0.5]\n[[unknown]]\nparameter = \"blocks.share.elongated\"\nrange = [0, 0.5]";
  EXPECT_EQ(asked("blocks.share.compact", both),
            "study.toml: every fraction of site north is an unknown, but their sum is 1; leave out "
            "one class, which gets the remainder");
  drawing(
      "{ count = 5, scheme = \"zingg\", shares = { disc = 0.5, rod = 0.25, blade = 0.25 }, "
      "mass_kg = { normal = [300, 30] } }");
  EXPECT_EQ(asked("blocks.mass_mean_kg", "[100, 900]"), "");
  EXPECT_EQ(
      asked("blocks.share.disc",
            "[0, 0.7]\n[[unknown]]\nparameter = \"blocks.share.rod\"\nrange = [0, 0.5]"),
      "study.toml: the unknown fractions of site north add up to 1.2 at the upper ends of their "
      "ranges; lower these until it is 1 at most");
  Campaign campaign = read_campaign(folder_ / "campaign.toml");
  set_parameter(campaign, "blocks.mass_std_kg", 40.0);
  set_parameter(campaign, "blocks.share.disc", 0.3);
  EXPECT_EQ(campaign.blocks.draw->mass->second, 40.0);
  EXPECT_EQ(campaign.blocks.draw->set_shares.at("disc"), 0.3);
  EXPECT_TRUE(is_block_parameter("blocks.share.disc"));
  EXPECT_FALSE(is_release_parameter("blocks.mass_kg"));
  EXPECT_FALSE(is_block_parameter("ground.blocks.friction"));
}

TEST_F(StudyFile, WhatMakesNoSenseIsRefused) {
  EXPECT_EQ(refused("ground.blue.friction", "ground.green.friction"),
            "study.toml:10: [[unknown]] parameter = \"ground.green.friction\": no campaign has "
            "this zone");
  EXPECT_EQ(refused("ground.blue.friction", "release.height_m"),
            "study.toml:10: [[unknown]] parameter = \"release.height_m\": no campaign releases "
            "blocks at a height_m");
  EXPECT_TRUE(refused("ground.blue.friction", "ground.blue.colour")
                  .starts_with("study.toml:10: [[unknown]] parameter = \"ground.blue.colour\": is "
                               "not a parameter that can be calibrated; these are "
                               "ground.ZONE.energy_restitution, ground.ZONE.friction"));
  EXPECT_EQ(refused("[0.4, 0.9]", "[0.9, 0.4]"),
            "study.toml:11: [[unknown]] range = [0.9, 0.4]: the lower end must come first");
  EXPECT_NE(refused("[0.4, 0.9]", "[nan, 0.4]"), "");
  EXPECT_NE(refused("[0.4, 0.9]", "[0.4, 900]"), "");
  EXPECT_NE(refused("[0.4, 0.9]", "0.4"), "");
  EXPECT_EQ(
      refused("parameter = \"contact.rolling_stiffness_n_m_rad\"\nrange = [1e5, 1e7]",
              "parameter = \"release.velocity_x_m_s\"\nrange = [-1, 1]"),
      "study.toml:16: [[unknown]] scale = \"log\": a logarithmic scale needs a range above 0");
  EXPECT_EQ(refused("parameter = \"contact.rolling_stiffness_n_m_rad\"\nrange = [1e5, 1e7]",
                    "parameter = \"ground.blue.friction\"\nrange = [0.1, 1]"),
            "study.toml:14: [[unknown]] parameter = \"ground.blue.friction\": is an unknown "
            "already");
  EXPECT_EQ(refused("campaign = \"campaign.toml\"", "campaign = \"none.toml\""),
            "study.toml:7: [[site]] campaign = \"none.toml\": no such file: none.toml");
  EXPECT_EQ(refused("members = 16", "members = 4"),
            "study.toml:2: [design] members = 4: must be from 8 to 4096");
  EXPECT_EQ(refused("use = \"fit\"", "use = \"both\""),
            "study.toml:20: [[observation]] use = \"both\": must be \"fit\" or \"keep\"");
  EXPECT_EQ(refused("use = \"fit\"", "use = \"keep\""),
            "study.toml: nothing is fitted: write a table [[observation]] with use = \"fit\"");
  EXPECT_EQ(refused("shape = \"compact\"", "block = \"B7\""),
            "study.toml:22: [[observation]] stops = \"stops.csv\": has 0 stops of these blocks; 3 "
            "are needed at least");
  EXPECT_EQ(refused("barrier = \"EC11\"", "barrier = \"EC99\""),
            "study.toml:27: [[observation]] barrier = \"EC99\": the campaign of site north has no "
            "such barrier");
  EXPECT_EQ(refused("passed = 19", "passed = 24"),
            "study.toml:29: [[observation]] passed = 24: exceeds the 23 releases");
  EXPECT_EQ(
      refused("releases = 23\n", ""),
      "study.toml:28: [[observation]] passed = 19: needs releases, the number of released blocks");
  EXPECT_EQ(refused("[8.4, 0.5]", "[8.4, 0]"),
            "study.toml:30: [[observation]] speed_m_s = [8.4, 0]: the error must be more than 0");
  EXPECT_EQ(refused("stops = \"stops.csv\"", "stops = \"stops.csv\"\nfigures = \"p0\""),
            "study.toml:23: [[observation]] figures = \"p0\": must be \"mean\", \"std\", "
            "\"aside\", or a percentile from \"p1\" to \"p99\"");
  EXPECT_EQ(refused("stops = \"stops.csv\"", "colour = 3"),
            "study.toml:22: [[observation]] colour = 3: unknown key; known here are name, site, "
            "use, shape, "
            "block, stops, figures, beyond_m, barrier, releases, passed, speed_m_s, spin_rad_s, "
            "height_m, energy_j, release, impact, depth_m, trajectories, times_s");
}

TEST_F(StudyFile, WhatIsFittedCantBeKept) {
  const std::string again =
      "[[observation]]\nname = \"again\"\nuse = \"keep\"\nstops = \"stops.csv\"\n";
  EXPECT_EQ(refused("[[observation]]\nname = \"passages\"",
                    again + "[[observation]]\nname = \"passages\""),
            "study.toml:26: [[observation]] use = \"keep\": observation stops uses the same "
            "blocks; observations of fitted blocks cannot be kept for validation");
  // Other blocks of the same table may be kept.
  write_text_file(folder_ / "stops.csv",
                  "x,y,shape\n1,0,compact\n2,0,compact\n4,0,compact\n5,0,elongated\n"
                  "6,0,elongated\n8,0,elongated\n");
  EXPECT_EQ(refused("[[observation]]\nname = \"passages\"",
                    again + "shape = \"elongated\"\n[[observation]]\nname = \"passages\""),
            "");
}

const std::string kImpact = R"([[observation]]
name = "hit"
use = "fit"
block = "B7"
impact = 2
speed_m_s = [3.0, 0.2]
depth_m = [0.12, 0.02]
)";

TEST_F(StudyFile, ImpactsAndScarsAreSamplesOfOne) {
  const CalibrationStudy study = read_study(kStudy + kImpact);
  const Observation& hit = study.observations.back();
  EXPECT_EQ(hit.moment, (ObservedMoment{ObservedMoment::Kind::kImpact, 2.0}));
  EXPECT_EQ(hit.releases, 1u);
  ASSERT_EQ(hit.statistics.size(), 2u);
  EXPECT_EQ(hit.statistics[1].kind, SummaryStatistic::Kind::kMeanScarDepth);
  EXPECT_EQ(hit.statistics[1].observed, 0.12);
  EXPECT_EQ(hit.statistics[1].measurement_error, 0.02);
  EXPECT_FALSE(hit.statistics[1].error);
  EXPECT_EQ(observed_moments(study.observations, 0),
            (std::vector<ObservedMoment>{{ObservedMoment::Kind::kImpact, 2.0}}));
  // Its depth kept, while its speed is fitted.
  std::string kept = kImpact;
  kept.replace(kept.find("hit"), 3, "scar");
  kept.replace(kept.find("\"fit\""), 5, "\"keep\"");
  EXPECT_EQ(refused("[[observation]]\nname = \"passages\"",
                    kImpact + kept + "[[observation]]\nname = \"passages\""),
            "study.toml:33: [[observation]] use = \"keep\": observation hit uses the same blocks; "
            "observations of fitted blocks cannot be kept for validation");
}

TEST_F(StudyFile, TrajectoriesAreObservedAtTimes) {
  write_text_file(folder_ / "paths.csv",
                  "trajectory,time_s,x_m,y_m,speed_m_s,spin_rad_s\n1,10,0,0,0,0\n1,11,4,0,8,2\n"
                  "1,12,12,0,8,2\n2,0,100,0,2,0\n2,2,104,0,2,4\n3,5,0,0,1,1\n3,5.5,3,0,7,1\n");
  const std::string followed =
      "[[observation]]\nname = \"paths\"\nuse = \"fit\"\ntrajectories = \"paths.csv\"\n";
  const CalibrationStudy study = read_study(kStudy + followed + "times_s = [0.5, 2]\n");
  ASSERT_EQ(study.observations.size(), 4u);
  const Observation& early = study.observations[2];
  EXPECT_EQ(early.name, "paths at 0.5 s");
  EXPECT_EQ(early.moment, (ObservedMoment{ObservedMoment::Kind::kTime, 0.5}));
  EXPECT_EQ(early.releases, 3u);
  EXPECT_EQ(early.clusters, (std::vector<std::size_t>{2, 1}));
  ASSERT_EQ(early.statistics.size(), 3u);
  EXPECT_NEAR(early.statistics[0].observed, (2.0 + 1.0 + 3.0) / 3.0 / std::sqrt(1.01), 1e-12);
  EXPECT_NEAR(early.statistics[1].observed, (4.0 + 2.0 + 7.0) / 3.0, 1e-12);
  EXPECT_NEAR(early.statistics[2].observed, (1.0 + 1.0 + 1.0) / 3.0, 1e-12);
  // The third is over by then.
  EXPECT_NEAR(study.observations[3].statistics[0].observed,
              (12.0 + 4.0 + 3.0) / 3.0 / std::sqrt(1.01), 1e-12);
  const auto refused_with = [&](const std::string& rest) {
    return refused("[[observation]]\nname = \"passages\"",
                   followed + rest + "[[observation]]\nname = \"passages\"");
  };
  EXPECT_EQ(refused_with("times_s = [3]\n"),
            "study.toml:28: [[observation]] times_s = [3]: the longest trajectory ends before 3");
  EXPECT_EQ(
      refused_with("times_s = [1]\ndepth_m = [0.1, 0.1]\n"),
      "study.toml:29: [[observation]] depth_m = [0.1, 0.1]: applies only to an observation with "
      "impact; leave it out here");
  EXPECT_EQ(refused_with("stops = \"stops.csv\"\n"),
            "study.toml:24: [[observation]]: has stops and trajectories; write two observations");
  EXPECT_EQ(refused_with("release = \"west\"\ntimes_s = [1]\n"),
            "study.toml:28: [[observation]] release = \"west\": the campaign of site north has no "
            "[[release]] of this name");
  write_text_file(folder_ / "paths.csv", "1 0 0 0 0 0\n1 0 1 0 0 0\n");
  EXPECT_EQ(refused_with("times_s = [1]\n"),
            "paths.csv:2: the times of a trajectory must rise; sort its rows");
}

TEST_F(StudyFile, CampaignsMustSayWhereDownslopeIs) {
  write_text_file(folder_ / "campaign.toml", with("downslope = [1, 0.1]\n", ""));
  EXPECT_EQ(refused("name = \"north\"", "name = \"north\""),
            "study.toml:7: [[site]] campaign = \"campaign.toml\": has no [run] downslope, along "
            "which positions of stops are measured; add it");
}

TEST_F(StudyFile, UncertainGroundThatIsNoUnknownIsRefused) {
  write_text_file(folder_ / "campaign.toml",
                  with("friction = 0.3\n", "friction = { uniform = [0.2, 0.4] }\n") +
                      "[ensemble]\nmembers = 3\n");
  EXPECT_EQ(
      refused("name = \"north\"", "name = \"north\""),
      "study.toml: ground.gray.friction has a distribution in the campaign of site north; make it "
      "an [[unknown]], or give it a value there");
}

TEST_F(StudyFile, StartsOfTheirOwnMakeClusters) {
  write_text_file(folder_ / "stops.csv",
                  "x,y,start_x,start_y,shape\n10,0,0,0,compact\n20,0,0,0,compact\n"
                  "40,0,1,0,compact\n");
  const Observation stops = read_study().observations[0];
  EXPECT_TRUE(stops.measured_from_own_start);
  EXPECT_EQ(stops.clusters, (std::vector<std::size_t>{2, 1}));
  EXPECT_NEAR(stops.statistics[0].observed, 69.0 / 3.0 / std::sqrt(1.01), 1e-9);
}

}  // namespace
}  // namespace clast
