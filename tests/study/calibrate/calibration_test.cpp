#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/statistics/statistics.hpp"
#include "study/calibrate/calibrate.hpp"
#include "study/calibrate/member_runs.hpp"
#include "tests/study/calibrate/made_up_site.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

TEST(Calibration, FindsWhatHasAnInfluenceAndLeavesTheRestAsItWas) {
  const CalibrationPosterior found = study_of({1.0}).posterior();
  EXPECT_TRUE(covers(found.marginals[0], kTruth[0])) << found.marginals[0].median;
  EXPECT_TRUE(covers(found.marginals[1], kTruth[1])) << found.marginals[1].median;
  EXPECT_LT(found.marginals[0].width, 0.5);
  EXPECT_LT(found.marginals[1].width, 0.6);
  // The prior is uniform from 0.01 to 0.2.
  EXPECT_TRUE(found.marginals[2].is_undetermined());
  EXPECT_NEAR(found.marginals[2].median, 0.105, 0.03);
  EXPECT_NEAR(found.marginals[2].low, 0.01 + 0.025 * 0.19, 0.01);
  EXPECT_NEAR(found.marginals[2].high, 0.2 - 0.025 * 0.19, 0.01);
  EXPECT_FALSE(found.fitted.failed());
  // The mean place varies with friction and rolling friction alone.
  EXPECT_GT(found.sensitivities[0][0].total, 0.1);
  EXPECT_GT(found.sensitivities[0][1].total, 0.1);
  EXPECT_LT(found.sensitivities[0][2].total, 0.05);
  EXPECT_GT(found.surrogates[0]->explained_variance, 0.9);
}

TEST(Calibration, SingleImpactsTellTheGround) {
  MadeUpStudy made(32, 60, 3);
  made.observe_throws(made.add_throws(), {}, kTruth, 8);
  const CalibrationPosterior found = made.posterior();
  for (std::size_t i = 0; i < kTruth.size(); ++i) {
    EXPECT_TRUE(covers(found.marginals[i], kTruth[i])) << i << " " << found.marginals[i].median;
    EXPECT_LT(found.marginals[i].width, 0.7) << i;
  }
  EXPECT_FALSE(found.fitted.failed());
  MadeUpStudy wrong(32, 60, 3);
  wrong.observe_throws(wrong.add_throws(), {.bend = 3.0}, kTruth, 8);
  EXPECT_TRUE(wrong.posterior().fitted.failed());
}

// One impact is a sample of one, however well it was measured.
TEST(Calibration, ASingleImpactScattersWithHowTheBlockHit) {
  MadeUpStudy made(32, 60, 3);
  made.observe_throws(made.add_throws(), {}, kTruth, 8);
  const double measured_well = made.posterior().marginals[0].width;
  for (Observation& observation : made.study.observations) observation.releases = 100;
  const double of_many = made.posterior().marginals[0].width;
  EXPECT_LT(of_many, 0.8 * measured_well);
  for (Observation& observation : made.study.observations) {
    for (SummaryStatistic& statistic : observation.statistics) statistic.measurement_error = 1e6;
  }
  EXPECT_TRUE(made.posterior().marginals[0].is_undetermined());
}

TEST(Calibration, TwoSitesTellMoreThanOne) {
  double one = 0.0, two = 0.0;
  for (const std::uint64_t seed : {1u, 2u}) {
    one += study_of({1.0}, seed).posterior().marginals[0].width;
    two += study_of({1.0, 1.3}, seed).posterior().marginals[0].width;
  }
  // Twice as many independent observations: the width goes with the square root.
  EXPECT_LT(two, 0.85 * one);
}

TEST(Calibration, AWrongLawFailsTheCheck) {
  EXPECT_TRUE(study_of({1.0}, 5, 8.0).posterior().fitted.failed());
}

TEST(Calibration, IsTheSameToTheBitOnAnyThreads) {
  const MadeUpStudy made = study_of({1.0});
  const CalibrationPosterior one = made.posterior(1), three = made.posterior(3);
  EXPECT_EQ(one.draws, three.draws);
  EXPECT_EQ(one.log_likelihood, three.log_likelihood);
}

TEST(Calibration, StatedErrorsWeigh) {
  MadeUpStudy made = study_of({1.0});
  for (Observation& observation : made.study.observations) {
    for (SummaryStatistic& statistic : observation.statistics) statistic.error = 1e6;
  }
  // Errors that large determine nothing.
  for (const MarginalPosterior& marginal : made.posterior().marginals)
    EXPECT_TRUE(marginal.is_undetermined());
}

// More parameters than figures: nothing can contradict, and the check says so.
TEST(Calibration, AFitOfOneFigureCannotBeContradicted) {
  MadeUpStudy made = study_of({1.0});
  made.study.observations.resize(1);
  made.study.observations[0].statistics.resize(1);
  const CalibrationPosterior found = made.posterior();
  EXPECT_EQ(found.fitted.statistics, 1u);
  EXPECT_FALSE(found.fitted.failed());
}

TEST(Calibration, AFigureThatNoMemberHasIsRefusedWhereItIsFitted) {
  MadeUpStudy made = study_of({1.0});
  for (auto& member : made.runs.outcomes[0]) {
    for (ReleaseOutcome& outcome : member) outcome.barriers = {OutcomeAtMoment()};
  }
  EXPECT_EQ(
      refusal<InputError>([&] { made.posterior(); }),
      "study.toml: observation site 1 compact passages, mean_speed_m_s: only 0 members of "
      "32 have a value, but 8 are needed; widen the ranges, simulate more releases, or set use = "
      "\"keep\"");
}

TEST(Calibration, AFewReleasesOfABlockAreRefused) {
  MadeUpStudy made = study_of({1.0});
  made.runs.outcomes[0][3].resize(15);  // eight compact, seven elongated
  EXPECT_EQ(refusal<InputError>([&] { made.posterior(); }),
            "observation site 1 elongated stops: a member has only 7 releases of these blocks, but "
            "8 are needed; raise [design] releases");
}

TEST(Calibration, PredictionsEndWhereFiguresDo) {
  MadeUpStudy made = study_of({1.0});
  for (const PredictedStatistic& one : made.posterior().predictions) {
    const SummaryStatistic& statistic =
        made.study.observations[one.observation].statistics[one.statistic];
    if (statistic.kind != SummaryStatistic::Kind::kPassedFraction) continue;
    EXPECT_GE(one.low, 0.0);
    EXPECT_LE(one.high, 1.0);
  }
}

// The mean place of compact blocks is 75 - 30 mu - 60 mu_R, with mu uniform from 0.3 to 0.9 and
// ln mu_R from ln 0.05 to ln 0.5.
TEST(Calibration, PriorPredictionsAreOfTheWholeRanges) {
  const MadeUpStudy made = study_of({1.0});
  const PredictedStatistic mean = made.posterior().predictions.front();
  ASSERT_EQ(made.study.observations[mean.observation].statistics[mean.statistic].name,
            "mean_place_m");
  std::vector<double> means;
  Random random(11);
  for (int i = 0; i < 20'000; ++i) {
    const double mu = 0.3 + 0.6 * random.uniform();
    means.push_back(75.0 - 30.0 * mu - 60.0 * 0.05 * std::pow(10.0, random.uniform()));
  }
  std::sort(means.begin(), means.end());
  EXPECT_NEAR(mean.prior.median, quantile(means, 0.5), 1.5);
  EXPECT_NEAR(mean.prior.low, quantile(means, 0.025), 3.0);
  EXPECT_NEAR(mean.prior.high, quantile(means, 0.975), 3.0);
  EXPECT_LT(mean.high - mean.low, 0.5 * (mean.prior.high - mean.prior.low));
}

TEST(Calibration, BlocksThatASiteLacksAreNamed) {
  MadeUpStudy made = study_of({1.0});
  made.study.observations[0].shape.clear();
  made.study.observations[0].block = "C";
  EXPECT_EQ(refusal<InputError>([&] { made.posterior(); }),
            "observation site 1 compact stops: the campaign of site site 1 has no block \"C\"; it "
            "has A, B");
}

TEST(MemberRuns, GoFromProcessToProcessBitByBit) {
  std::vector<ReleaseOutcome> outcomes(2);
  outcomes[0] = {3, 4294967295u, {0.1, -1e300}, {1.0 / 3.0, 5e-324}, {{}, {1.0, 2.0}}, 7, {}};
  outcomes[1].moments.resize(3);
  outcomes[1].moments[2].position = {652013.25, 5203000.125};
  const std::string bytes = study_detail::serialize_outcomes(outcomes);
  const std::vector<ReleaseOutcome> back = study_detail::deserialize_outcomes(bytes);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].block, 3u);
  EXPECT_EQ(back[0].point, 4294967295u);
  EXPECT_EQ(back[0].start, outcomes[0].start);
  EXPECT_EQ(back[0].stop, outcomes[0].stop);
  EXPECT_EQ(back[0].release, 7u);
  ASSERT_EQ(back[0].barriers.size(), 2u);
  EXPECT_FALSE(back[0].barriers[0].passed());
  EXPECT_EQ(back[0].barriers[1].spin, 2.0);
  EXPECT_EQ(back[1].moments[2].position, outcomes[1].moments[2].position);
  EXPECT_EQ(study_detail::serialize_outcomes(back), bytes);
  EXPECT_TRUE(study_detail::deserialize_outcomes("").empty());
}

}  // namespace
}  // namespace clast
