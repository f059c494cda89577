#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/hdf5_file.hpp"
#include "core/progress.hpp"
#include "core/statistics.hpp"
#include "core/text_file.hpp"
#include "study/calibration/calibrate.hpp"
#include "study/calibration/member_runs.hpp"
#include "tests/study/calibration/made_up_site.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

const std::vector<double> kTruth = {0.6, 0.2, 0.05};

MadeUpStudy study_of(const std::vector<double>& reaches, std::uint64_t seed = 5,
                     double bend = 0.0) {
  MadeUpStudy made(32, 64, seed);
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    MadeUpSite site;
    site.reach = reaches[i];
    site.seed = seed + i;
    const std::size_t number = made.add_site("site " + std::to_string(i + 1), site);
    site.bend = bend;  // of the field alone
    made.observe(number, site, kTruth, 24, true, 31 * seed + i);
  }
  return made;
}

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
  EXPECT_GT(found.surrogates[0]->explained, 0.9);
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
    for (Figure& figure : observation.figures) figure.measuring_error = 1e6;
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
    for (Figure& figure : observation.figures) figure.error = 1e6;
  }
  // Errors that large determine nothing.
  for (const Marginal& marginal : made.posterior().marginals)
    EXPECT_TRUE(marginal.is_undetermined());
}

// More parameters than figures: nothing can contradict, and the check says so.
TEST(Calibration, AFitOfOneFigureCannotBeContradicted) {
  MadeUpStudy made = study_of({1.0});
  made.study.observations.resize(1);
  made.study.observations[0].figures.resize(1);
  const CalibrationPosterior found = made.posterior();
  EXPECT_EQ(found.fitted.figures, 1u);
  EXPECT_FALSE(found.fitted.failed());
}

TEST(Calibration, AFigureThatNoMemberHasIsRefusedWhereItIsFitted) {
  MadeUpStudy made = study_of({1.0});
  for (auto& member : made.runs.outcomes[0]) {
    for (ReleaseOutcome& outcome : member) outcome.barriers = {OutcomeAt()};
  }
  EXPECT_EQ(refusal<InputError>([&] { made.posterior(); }),
            "study.toml: observation site 1 compact passages, mean_speed_m_s: only 0 members of "
            "32 have it, and 8 are needed; widen the ranges, simulate more releases, or keep it");
}

TEST(Calibration, AFewReleasesOfABlockAreRefused) {
  MadeUpStudy made = study_of({1.0});
  made.runs.outcomes[0][3].resize(15);  // eight compact, seven elongated
  EXPECT_EQ(refusal<InputError>([&] { made.posterior(); }),
            "observation site 1 elongated stops: a member has only 7 releases of these blocks, and "
            "8 are needed; raise [design] releases");
}

TEST(Calibration, PredictionsEndWhereFiguresDo) {
  MadeUpStudy made = study_of({1.0});
  for (const PredictedFigure& one : made.posterior().predicted) {
    const Figure& figure = made.study.observations[one.observation].figures[one.figure];
    if (figure.kind != Figure::Kind::kPassed) continue;
    EXPECT_GE(one.low, 0.0);
    EXPECT_LE(one.high, 1.0);
  }
}

// The mean place of compact blocks is 75 - 30 mu - 60 mu_R, with mu uniform from 0.3 to 0.9 and
// ln mu_R from ln 0.05 to ln 0.5.
TEST(Calibration, PriorPredictionsAreOfTheWholeRanges) {
  const MadeUpStudy made = study_of({1.0});
  const PredictedFigure mean = made.posterior().predicted.front();
  ASSERT_EQ(made.study.observations[mean.observation].figures[mean.figure].name, "mean_place_m");
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
  outcomes[1].moments[2].place = {652013.25, 5203000.125};
  const std::string bytes = study_detail::packed_outcomes(outcomes);
  const std::vector<ReleaseOutcome> back = study_detail::unpacked_outcomes(bytes);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[0].block, 3u);
  EXPECT_EQ(back[0].point, 4294967295u);
  EXPECT_EQ(back[0].start, outcomes[0].start);
  EXPECT_EQ(back[0].stop, outcomes[0].stop);
  EXPECT_EQ(back[0].release, 7u);
  ASSERT_EQ(back[0].barriers.size(), 2u);
  EXPECT_FALSE(back[0].barriers[0].passed());
  EXPECT_EQ(back[0].barriers[1].spin, 2.0);
  EXPECT_EQ(back[1].moments[2].place, outcomes[1].moments[2].place);
  EXPECT_EQ(study_detail::packed_outcomes(back), bytes);
  EXPECT_TRUE(study_detail::unpacked_outcomes("").empty());
}

/// A calibration of a made-up study through its file.
class CalibrationFile : public testing::Test {
 protected:
  CalibrationFile() : made(study_of({1.0, 1.3})) {
    made.study.design.members = 16;
    made.study.design.draws = 200;
    made.study.text = "# made up\n";
    simulator.sites = made.runs.sites;
    simulator.inputs = {"made-up.toml 00"};
    simulator.simulate = [this](std::size_t site, std::uint32_t member,
                                const std::vector<double>&) {
      if (++simulated > most) throw Cancelled();
      return made.runs.outcomes[site][member];
    };
  }
  Calibration run(const CalibrateOptions& options = {}) {
    return calibrate_with(simulator, made.study, target(), options);
  }
  std::filesystem::path target() const { return folder / "posterior.h5"; }

  MadeUpStudy made;
  CalibrationSimulator simulator;
  std::size_t simulated = 0, most = 1000;
  ScratchFolder folder;
};

TEST_F(CalibrationFile, HoldsRunsAndDraws) {
  const Calibration calibration = run();
  EXPECT_EQ(simulated, 32u);
  const StoredCalibration stored = read_calibration_runs(target());
  EXPECT_EQ(stored.design_sha256, calibration.stored.design_sha256);
  ASSERT_EQ(stored.runs.outcomes.size(), 2u);
  const ReleaseOutcome& kept = stored.runs.outcomes[1][7][3];
  const ReleaseOutcome& had = made.runs.outcomes[1][7][3];
  EXPECT_EQ(kept.stop, had.stop);
  EXPECT_EQ(kept.point, had.point);
  EXPECT_EQ(kept.barriers[0].passed(), had.barriers[0].passed());
  const PosteriorDraws draws = read_posterior_draws(target());
  EXPECT_EQ(draws.parameters[1], "ground.scree.rolling_friction");
  ASSERT_EQ(draws.draws.size(), 200u);
  EXPECT_EQ(draws.draws[5][1], calibration.posterior.draws(1, 5));
}

TEST_F(CalibrationFile, InterruptedGoesOnToTheSameBits) {
  const Calibration whole = run();
  std::filesystem::remove(target());
  simulated = 0;
  most = 11;
  EXPECT_THROW(run(), Cancelled);
  EXPECT_FALSE(std::filesystem::exists(target()));
  EXPECT_EQ(refusal<InputError>([&] { run(); }),
            partial_calibration(target()).string() +
                ": holds the members of an interrupted calibration; `resume` goes on with it, or "
                "delete the file to start afresh");
  EXPECT_EQ(
      refusal<InputError>([&] { read_posterior_draws(partial_calibration(target())); }),
      partial_calibration(target()).string() +
          ": is a calibration without draws, interrupted or one of several shards; go on with "
          "it, or join the shards first");
  simulated = 0;
  most = 1000;
  std::size_t before = 0;
  CalibrateOptions options;
  options.resume = true;
  options.progress = [&](const ProgressStep& step) { before = step.before; };
  EXPECT_EQ(run(options).posterior.draws, whole.posterior.draws);
  EXPECT_EQ(simulated, 21u);
  EXPECT_EQ(before, 11u);
  EXPECT_FALSE(std::filesystem::exists(partial_calibration(target())));
}

TEST_F(CalibrationFile, ShardsJoinedAreTheWhole) {
  const Calibration whole = run();
  CalibrateOptions join;
  for (std::uint32_t i = 1; i <= 3; ++i) {
    simulated = 0;
    CalibrateOptions options;
    options.shard = {i, 3};
    const auto part = folder / ("part" + std::to_string(i) + ".h5");
    std::size_t total = 0;
    options.progress = [&](const ProgressStep& step) { total = step.total; };
    calibrate_with(simulator, made.study, part, options);
    EXPECT_EQ(simulated, i == 1 ? 12u : 10u);  // 16 members at two sites
    EXPECT_EQ(total, simulated);
    EXPECT_NE(refusal<InputError>([&] { read_posterior_draws(part); }), "");
    join.parts.push_back(part);
  }
  simulated = 0;
  const Calibration joined = calibrate_with(simulator, made.study, folder / "joined.h5", join);
  EXPECT_EQ(simulated, 0u);
  EXPECT_EQ(joined.posterior.draws, whole.posterior.draws);
  join.parts.erase(join.parts.begin() + 1);
  join.replace = true;
  const auto refused = [&] {
    return refusal<InputError>(
        [&] { calibrate_with(simulator, made.study, folder / "joined.h5", join); });
  };
  EXPECT_EQ(refused(),
            "member 2 of 16 is in none of the parts; give the files of all shards, each finished");
  EXPECT_EQ(read_posterior_draws(folder / "joined.h5").draws.size(), 200u);  // it is still there
  made.study.design.seed = 99;
  EXPECT_EQ(refused(), join.parts[0].string() +
                           ": was begun with other sites, unknowns, members, inputs or program; "
                           "simulate that shard of this study");
}

TEST_F(CalibrationFile, KeepsImpactsAndTimes) {
  const std::vector<Moment> moments = {{Moment::Kind::kImpact, 2.0}, {Moment::Kind::kTime, 0.5}};
  for (std::size_t site = 0; site < 2; ++site) {
    simulator.sites[site].moments = moments;
    simulator.sites[site].releases = {"low", "high"};
    for (auto& member : made.runs.outcomes[site]) {
      for (ReleaseOutcome& outcome : member) {
        outcome.release = 1;
        outcome.moments.resize(2);
        outcome.moments[0].depth = 0.1 * outcome.stop.x();
        outcome.moments[1].speed = outcome.stop.y();
        outcome.moments[1].place = outcome.stop;
      }
    }
  }
  run();
  const StoredCalibration stored = read_calibration_runs(target());
  EXPECT_EQ(stored.runs.sites[0].moments, moments);
  EXPECT_EQ(stored.runs.sites[0].releases, (std::vector<std::string>{"low", "high"}));
  const ReleaseOutcome& kept = stored.runs.outcomes[1][7][3];
  const ReleaseOutcome& had = made.runs.outcomes[1][7][3];
  EXPECT_EQ(kept.release, 1u);
  EXPECT_EQ(kept.moments[0].depth, had.moments[0].depth);
  EXPECT_FALSE(kept.moments[0].passed());
  EXPECT_EQ(kept.moments[1].speed, had.moments[1].speed);
  EXPECT_EQ(kept.moments[1].place, had.moments[1].place);
  CalibrateOptions options;
  options.resume = true;
  simulated = 0;
  simulator.sites[0].moments.pop_back();  // fewer are there too
  run(options);
  EXPECT_EQ(simulated, 0u);
  simulator.sites[1].moments.push_back({Moment::Kind::kTime, 0.75});
  EXPECT_EQ(refusal<InputError>([&] { run(options); }),
            target().string() +
                ": the members of site site 2 were simulated to be observed at other impacts or "
                "times; delete the file, or give another output");
}

TEST_F(CalibrationFile, OtherObservationsUseTheSameRuns) {
  run();
  simulated = 0;
  made.study.observations.pop_back();
  CalibrateOptions options;
  options.resume = true;
  run(options);
  EXPECT_EQ(simulated, 0u);
  made.study.unknowns[0].high = 0.95;
  EXPECT_EQ(refusal<InputError>([&] { run(options); }),
            target().string() +
                ": was begun with other sites, unknowns, members, inputs or program; delete it, or "
                "give another output");
}

TEST_F(CalibrationFile, MembersOfOtherPhysicsAreNotTakenOver) {
  const std::string ours(64, 'a'), other(64, 'b');
  simulator.physics_digest = ours;
  EXPECT_EQ(run().stored.physics_digest, ours);
  EXPECT_EQ(read_calibration_runs(target()).physics_digest, ours);
  CalibrateOptions resume, join;
  resume.resume = true;
  run(resume);
  join.parts = {target()};
  const auto joined = [&] {
    return calibrate_with(simulator, made.study, folder / "joined.h5", join).stored.physics_digest;
  };
  EXPECT_EQ(joined(), ours);
  simulator.physics_digest = other;
  const std::string differ = target().string() +
                             ": blocks move differently in this clast (physics digest aaaaaaaaaa, "
                             "here bbbbbbbbbb) than in the one that simulated its members, which "
                             "has the same version number; ";
  EXPECT_EQ(refusal<InputError>([&] { run(resume); }),
            differ + "delete it, or give another output");
  join.replace = true;
  EXPECT_EQ(refusal<InputError>([&] { joined(); }), differ + "simulate that shard of this study");
}

TEST_F(CalibrationFile, SitesWithoutBarriersGoOnToo) {
  for (std::size_t site = 0; site < 2; ++site) {
    simulator.sites[site].barriers.clear();
    for (auto& member : made.runs.outcomes[site]) {
      for (ReleaseOutcome& outcome : member) outcome.barriers.clear();
    }
  }
  std::erase_if(made.study.observations,
                [](const Observation& one) { return !one.barrier.empty(); });
  const Calibration whole = run();
  CalibrateOptions options;
  options.resume = true;
  simulated = 0;
  EXPECT_EQ(run(options).posterior.draws, whole.posterior.draws);
  EXPECT_EQ(simulated, 0u);
}

// What is not known of their members is not said of the new file.
TEST_F(CalibrationFile, FilesOfOlderProgramsGoOnWithoutADigest) {
  run();
  simulator.physics_digest = std::string(64, 'b');
  CalibrateOptions options;
  options.resume = true;
  simulated = 0;
  EXPECT_EQ(run(options).stored.physics_digest, "");
  EXPECT_EQ(simulated, 0u);
  CalibrateOptions join;
  join.parts = {target()};
  EXPECT_EQ(calibrate_with(simulator, made.study, folder / "joined.h5", join).stored.physics_digest,
            "");
}

TEST_F(CalibrationFile, APosteriorIsNotReplacedUnasked) {
  run();
  EXPECT_NE(refusal<InputError>([&] { run(); }), "");
  CalibrateOptions options;
  options.replace = true;
  run(options);
  write_text_file(folder / "notes.txt", "mine");
  EXPECT_NE(refusal<InputError>(
                [&] { calibrate_with(simulator, made.study, folder / "notes.txt", options); }),
            "");
  EXPECT_EQ(read_text_file(folder / "notes.txt"), "mine");
}

}  // namespace
}  // namespace clast
