// Calibrations through their files: what they hold, how they go on, and what they refuse.
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/files/hdf5_file.hpp"
#include "core/files/text_file.hpp"
#include "core/progress.hpp"
#include "study/calibrate/calibrate.hpp"
#include "tests/study/calibrate/made_up_site.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

/// A calibration of a made-up study through its file.
class CalibrationFile : public testing::Test {
 protected:
  CalibrationFile() : made(study_of({1.0, 1.3})) {
    made.study.design.member_count = 16;
    made.study.design.draw_count = 200;
    made.study.text = "# made up\n";
    simulator.sites = made.runs.sites;
    simulator.inputs = {"made-up.toml 00"};
    simulator.simulate = [this](std::size_t site, std::uint32_t member,
                                const std::vector<double>&) {
      if (++simulated > maximum) throw Cancelled();
      return made.runs.outcomes[site][member];
    };
  }
  Calibration run(const CalibrationOptions& options = {}) {
    return run_calibration_with(simulator, made.study, target(), options);
  }
  std::filesystem::path target() const { return folder / "posterior.h5"; }

  MadeUpStudy made;
  CalibrationBackend simulator;
  std::size_t simulated = 0, maximum = 1000;
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
  maximum = 11;
  EXPECT_THROW(run(), Cancelled);
  EXPECT_FALSE(std::filesystem::exists(target()));
  EXPECT_EQ(refusal<InputError>([&] { run(); }),
            calibration_journal_path(target()).string() +
                ": holds the members of an interrupted calibration; `resume` continues it, or "
                "delete the file to start again");
  EXPECT_EQ(refusal<InputError>([&] { read_posterior_draws(calibration_journal_path(target())); }),
            calibration_journal_path(target()).string() +
                ": is a calibration without draws, because it was interrupted or is one of several "
                "shards; continue it, or join the shards first");
  simulated = 0;
  maximum = 1000;
  std::size_t before = 0;
  CalibrationOptions options;
  options.resume = true;
  options.progress = [&](const ProgressUpdate& step) { before = step.done_before; };
  EXPECT_EQ(run(options).posterior.draws, whole.posterior.draws);
  EXPECT_EQ(simulated, 21u);
  EXPECT_EQ(before, 11u);
  EXPECT_FALSE(std::filesystem::exists(calibration_journal_path(target())));
}

TEST_F(CalibrationFile, ShardsJoinedAreTheWhole) {
  const Calibration whole = run();
  CalibrationOptions join;
  for (std::uint32_t i = 1; i <= 3; ++i) {
    simulated = 0;
    CalibrationOptions options;
    options.shard = {i, 3};
    const auto part = folder / ("part" + std::to_string(i) + ".h5");
    std::size_t total = 0;
    options.progress = [&](const ProgressUpdate& step) { total = step.total; };
    run_calibration_with(simulator, made.study, part, options);
    EXPECT_EQ(simulated, i == 1 ? 12u : 10u);  // 16 members at two sites
    EXPECT_EQ(total, simulated);
    EXPECT_NE(refusal<InputError>([&] { read_posterior_draws(part); }), "");
    join.parts.push_back(part);
  }
  simulated = 0;
  const Calibration joined =
      run_calibration_with(simulator, made.study, folder / "joined.h5", join);
  EXPECT_EQ(simulated, 0u);
  EXPECT_EQ(joined.posterior.draws, whole.posterior.draws);
  join.parts.erase(join.parts.begin() + 1);
  join.replace = true;
  const auto refused = [&] {
    return refusal<InputError>(
        [&] { run_calibration_with(simulator, made.study, folder / "joined.h5", join); });
  };
  EXPECT_EQ(refused(),
            "member 2 of 16 is in none of the parts; give the finished files of all shards");
  EXPECT_EQ(read_posterior_draws(folder / "joined.h5").draws.size(), 200u);  // it is still there
  made.study.design.seed = 99;
  EXPECT_EQ(refused(),
            join.parts[0].string() +
                ": was started with different sites, unknowns, members, inputs or program; "
                "simulate that shard of this study");
}

TEST_F(CalibrationFile, KeepsImpactsAndTimes) {
  const std::vector<ObservedMoment> moments = {{ObservedMoment::Kind::kImpact, 2.0},
                                               {ObservedMoment::Kind::kTime, 0.5}};
  for (std::size_t site = 0; site < 2; ++site) {
    simulator.sites[site].moments = moments;
    simulator.sites[site].releases = {"low", "high"};
    for (auto& member : made.runs.outcomes[site]) {
      for (ReleaseOutcome& outcome : member) {
        outcome.release = 1;
        outcome.moments.resize(2);
        outcome.moments[0].depth = 0.1 * outcome.stop.x();
        outcome.moments[1].speed = outcome.stop.y();
        outcome.moments[1].position = outcome.stop;
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
  EXPECT_EQ(kept.moments[1].position, had.moments[1].position);
  CalibrationOptions options;
  options.resume = true;
  simulated = 0;
  simulator.sites[0].moments.pop_back();  // fewer are there too
  run(options);
  EXPECT_EQ(simulated, 0u);
  simulator.sites[1].moments.push_back({ObservedMoment::Kind::kTime, 0.75});
  EXPECT_EQ(refusal<InputError>([&] { run(options); }),
            target().string() +
                ": the members of site site 2 were simulated for observations at other impacts or "
                "times; delete the file, or give another output");
}

TEST_F(CalibrationFile, OtherObservationsUseTheSameRuns) {
  run();
  simulated = 0;
  made.study.observations.pop_back();
  CalibrationOptions options;
  options.resume = true;
  run(options);
  EXPECT_EQ(simulated, 0u);
  made.study.unknowns[0].high = 0.95;
  EXPECT_EQ(
      refusal<InputError>([&] { run(options); }),
      target().string() +
          ": was started with different sites, unknowns, members, inputs or program; delete it, or "
          "give another output");
}

TEST_F(CalibrationFile, MembersOfOtherPhysicsAreNotTakenOver) {
  const std::string ours(64, 'a'), other(64, 'b');
  simulator.physics_digest = ours;
  EXPECT_EQ(run().stored.physics_digest, ours);
  EXPECT_EQ(read_calibration_runs(target()).physics_digest, ours);
  CalibrationOptions resume, join;
  resume.resume = true;
  run(resume);
  join.parts = {target()};
  const auto joined = [&] {
    return run_calibration_with(simulator, made.study, folder / "joined.h5", join)
        .stored.physics_digest;
  };
  EXPECT_EQ(joined(), ours);
  simulator.physics_digest = other;
  const std::string differ =
      target().string() +
      ": this version of clast computes different motions (physics digest aaaaaaaaaa, "
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
  CalibrationOptions options;
  options.resume = true;
  simulated = 0;
  EXPECT_EQ(run(options).posterior.draws, whole.posterior.draws);
  EXPECT_EQ(simulated, 0u);
}

// What is not known of their members is not said of the new file.
TEST_F(CalibrationFile, FilesOfOlderProgramsGoOnWithoutADigest) {
  run();
  simulator.physics_digest = std::string(64, 'b');
  CalibrationOptions options;
  options.resume = true;
  simulated = 0;
  EXPECT_EQ(run(options).stored.physics_digest, "");
  EXPECT_EQ(simulated, 0u);
  CalibrationOptions join;
  join.parts = {target()};
  EXPECT_EQ(
      run_calibration_with(simulator, made.study, folder / "joined.h5", join).stored.physics_digest,
      "");
}

TEST_F(CalibrationFile, APosteriorIsNotReplacedUnasked) {
  run();
  EXPECT_NE(refusal<InputError>([&] { run(); }), "");
  CalibrationOptions options;
  options.replace = true;
  run(options);
  write_text_file(folder / "notes.txt", "mine");
  EXPECT_NE(refusal<InputError>([&] {
              run_calibration_with(simulator, made.study, folder / "notes.txt", options);
            }),
            "");
  EXPECT_EQ(read_text_file(folder / "notes.txt"), "mine");
}

}  // namespace
}  // namespace clast
