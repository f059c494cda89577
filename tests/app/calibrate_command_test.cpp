#include <nlohmann/json.hpp>

#include "dem/simulation/physics_digest.hpp"
#include "study/calibrate/posterior_file.hpp"
#include "tests/app/mpi_run.hpp"
#include "tests/app/slope_campaign.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

/// Two blocks on a slope that ends on a flat, and a few stops on it.
class CalibrateCommand : public SlopeCampaign {
 protected:
  void SetUp() override {
    SlopeCampaign::SetUp();
    write_text_file(folder / "campaign.toml",
                    replaced(replaced(slope_campaign(), "max_time_s = 5", "max_time_s = 12"),
                             "[run]\n", "[run]\ndownslope = [1, 0]\n"));
    write_text_file(folder / "stops.csv", "x,y\n17,1\n19,0\n22,-1\n21,2\n24,0\n");
    write_text_file(folder / "study.toml", study());
  }
  static std::string study() {
    return "[design]\nmembers = 12\nreleases = 8\ndraws = 200\n"
           "[[site]]\nname = \"slope\"\ncampaign = \"campaign.toml\"\n"
           "[[unknown]]\nparameter = \"ground.slope.friction\"\nrange = [0.3, 0.6]\n"
           "[[unknown]]\nparameter = \"release.height_m\"\nrange = [0.3, 1.5]\n"
           "[[observation]]\nname = \"stops\"\nuse = \"fit\"\nstops = \"stops.csv\"\n"
           "[[observation]]\nname = \"middle\"\nuse = \"keep\"\nbarrier = \"B1\"\n"
           "releases = 10\npassed = 9\nspeed_m_s = [4.0, 1.0]\n";
  }
};

TEST_F(CalibrateCommand, WritesPosteriorAndPageAndPrintsTheAnswer) {
  const ProgramRun run = run_clast({"calibrate", "study.toml", "--threads", "2"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* part : {"ground.slope.friction", "release.height_m", "mean_place_m",
                           "mean_speed_m_s", "[ground.flat]", "posterior.html"}) {
    EXPECT_TRUE(contains(run.out, part)) << part << "\n" << run.out;
  }
  const PosteriorDraws draws = read_posterior_draws(folder / "posterior.h5");
  EXPECT_EQ(draws.draws.size(), 200u);
  for (const std::vector<double>& draw : draws.draws) {
    EXPECT_GE(draw[0], 0.3);
    EXPECT_LE(draw[0], 0.6);
  }
  const std::string page = read_text_file(folder / "posterior.html");
  for (const char* part :
       {"Ground parameters estimated from observations", "Observed against predicted",
        "Sensitivity of the statistics to the parameters", "friction of slope"}) {
    EXPECT_TRUE(contains(page, part)) << part;
  }

  // Threads change nothing; other observations need no new runs.
  const ProgramRun again = run_clast(
      {"calibrate", "study.toml", "-o", "one.h5", "--threads", "1", "--json"}, folder.path());
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(read_posterior_draws(folder / "one.h5").draws, draws.draws);
  const Json json = Json::parse(again.out);
  EXPECT_EQ(json["unknowns"].size(), 2u);
  EXPECT_EQ(json["figures"].size(), 4u);
  EXPECT_EQ(json["fit"]["figures"], 2);
  EXPECT_EQ(json["prediction"]["figures"], 2);
  expect_refused(folder, {"calibrate", "study.toml"}, 1, "posterior.h5");
  write_text_file(folder / "study.toml", replaced(study(), "stops = \"stops.csv\"",
                                                  "stops = \"stops.csv\"\nfigures = \"p50\""));
  const ProgramRun other = run_clast({"calibrate", "study.toml", "--resume"}, folder.path());
  ASSERT_EQ(other.exit_code, 0) << other.err;
  EXPECT_TRUE(contains(other.out, "p50_place_m"));
  StoredCalibration altered = read_calibration_runs(folder / "posterior.h5");
  EXPECT_EQ(altered.physics_digest, physics_digest());
  altered.physics_digest.front() = altered.physics_digest.front() == '0' ? '1' : '0';
  write_posterior(folder / "altered.h5", read_calibration_study(folder / "study.toml"), altered,
                  nullptr, {.kind = kPosteriorFormat});
  expect_refused(folder, {"calibrate", "study.toml", "-o", "altered.h5", "--resume"}, 1,
                 "this version of clast computes different motions");
  write_text_file(folder / "study.toml", replaced(study(), "0.6", "0.7"));
  expect_refused(folder, {"calibrate", "study.toml", "--resume"}, 1,
                 "was started with different sites, unknowns");
}

TEST_F(CalibrateCommand, IsTheSameInShardsJoined) {
  const auto run = [&](const std::vector<std::string>& words) {
    const ProgramRun program = run_clast(words, folder.path());
    EXPECT_EQ(program.exit_code, 0) << program.err;
    return program.out;
  };
  run({"calibrate", "study.toml", "-o", "whole.h5"});
  EXPECT_TRUE(contains(run({"calibrate", "study.toml", "-o", "p.h5", "--shard", "1/2"}),
                       "p.1of2.h5: 6 of 12 members simulated"));
  EXPECT_FALSE(fs::exists(folder / "p.1of2.html"));
  expect_refused(folder, {"calibrate", "study.toml", "-o", "p.h5", "--merge", "p.1of2.h5"}, 1,
                 "member 2 of 12 is in none of the parts");
  run({"calibrate", "study.toml", "-o", "p.h5", "--shard", "2/2"});
  run({"calibrate", "study.toml", "-o", "p.h5", "--merge", "p.1of2.h5", "p.2of2.h5"});
  EXPECT_EQ(read_posterior_draws(folder / "p.h5").draws,
            read_posterior_draws(folder / "whole.h5").draws);
  EXPECT_TRUE(fs::exists(folder / "p.html"));
  expect_refused(folder, {"calibrate", "study.toml", "--shard", "3/2"}, 2, "3/2");
  expect_refused(folder, {"calibrate", "study.toml", "--shard", "1/2", "--merge", "p.1of2.h5"}, 2,
                 "--shard");
}

TEST_F(CalibrateCommand, BlocksDrawnByMembersAreTheSameInShardsAndAfterAnInterruption) {
  write_text_file(folder / "campaign.toml",
                  replaced(read_text_file(folder / "campaign.toml"), "library = \"blocks.h5\"",
                           "library = \"blocks.h5\"\ndraw = { count = 8, shares = { compact = 0.5, "
                           "elongated = 0.5 }, mass_kg = { log_normal = [300, 0.3] } }"));
  const std::string more =
      "[[unknown]]\nparameter = \"blocks.mass_median_kg\"\nrange = [100, 900]\nscale = \"log\"\n"
      "[[unknown]]\nparameter = \"blocks.share.elongated\"\nrange = [0, 1]\n";
  write_text_file(folder / "study.toml",
                  replaced(study(), "[[observation]]", more + "[[observation]]"));
  const auto run = [&](const std::vector<std::string>& words) {
    const ProgramRun program = run_clast(words, folder.path());
    EXPECT_EQ(program.exit_code, 0) << program.err;
    return program.out;
  };
  run({"check", "study.toml"});
  const std::string said = run({"calibrate", "study.toml", "-o", "whole.h5", "--threads", "2"});
  for (const char* part : {"blocks.share.elongated", "# blocks.mass_median_kg = "}) {
    EXPECT_TRUE(contains(said, part)) << said;
  }
  const std::string page = read_text_file(folder / "whole.html");
  for (const char* part : {"mass median of blocks, kg", "fraction of elongated blocks"}) {
    EXPECT_TRUE(contains(page, part)) << part;
  }
  run({"calibrate", "study.toml", "-o", "p.h5", "--shard", "2/2", "--threads", "1"});
  run({"calibrate", "study.toml", "-o", "p.h5", "--shard", "1/2"});
  run({"calibrate", "study.toml", "-o", "p.h5", "--merge", "p.1of2.h5", "p.2of2.h5"});
  const auto draws = read_posterior_draws(folder / "whole.h5").draws;
  EXPECT_EQ(read_posterior_draws(folder / "p.h5").draws, draws);
  // The file of a shard is what an interruption leaves.
  fs::rename(folder / "p.2of2.h5", folder / "again.h5.part");
  run({"calibrate", "study.toml", "-o", "again.h5", "--resume"});
  EXPECT_EQ(read_posterior_draws(folder / "again.h5").draws, draws);
}

#ifdef CLAST_MPIRUN
TEST_F(CalibrateCommand, IsTheSameOnTwoProcesses) {
  const ProgramRun one = run_clast({"calibrate", "study.toml", "-o", "one.h5"}, folder.path());
  ASSERT_EQ(one.exit_code, 0) << one.err;
  const ProgramRun two = mpirun("2", {"calibrate", "study.toml", "-o", "two.h5"}, folder.path());
  ASSERT_EQ(two.exit_code, 0) << two.err;
  EXPECT_EQ(two.out.find("two.h5"), two.out.rfind("two.h5")) << two.out;  // said by one of them
  EXPECT_EQ(read_posterior_draws(folder / "two.h5").draws,
            read_posterior_draws(folder / "one.h5").draws);
  const ProgramRun kept = mpirun("2", {"calibrate", "study.toml", "-o", "two.h5"}, folder.path());
  EXPECT_NE(kept.exit_code, 0);
  EXPECT_TRUE(contains(kept.err, "two.h5")) << kept.err;
  // A member that fails, here by having too few releases of the cube, ends all processes, wherever
  // it was simulated.
  write_text_file(folder / "study.toml",
                  replaced(study(), "use = \"fit\"", "use = \"fit\"\nblock = \"cube\""));
  write_text_file(folder / "stops.csv", "x,y,block\n17,1,cube\n19,0,cube\n22,-1,cube\n");
  const ProgramRun failed = mpirun("2", {"calibrate", "study.toml", "-o", "f.h5"}, folder.path());
  EXPECT_NE(failed.exit_code, 0);
  EXPECT_TRUE(contains(failed.err, "a member has only 4 releases of these blocks")) << failed.err;
  EXPECT_FALSE(fs::exists(folder / "f.h5"));
}
#endif

TEST_F(CalibrateCommand, RefusesWhatItCantDo) {
  expect_refused(folder, {"calibrate", "none.toml"}, 1, "none.toml");
  expect_refused(folder, {"calibrate"}, 2, "study");
  expect_refused(folder, {"calibrate", "study.toml", "-o", "posterior.html"}, 2,
                 "has the same name as its HTML page");
  expect_refused(folder, {"calibrate", "study.toml", "-o", "campaign.toml"}, 1, "campaign.toml");
  expect_refused(folder, {"calibrate", "study.toml", "--resume", "-o", "blocks.h5"}, 1,
                 "blocks.h5");
  write_text_file(folder / "study.toml", "");
  expect_refused(folder, {"calibrate", "study.toml"}, 1, "no site");
  write_text_file(folder / "study.toml", replaced(study(), "releases = 8", "releases = 800"));
  expect_refused(folder, {"calibrate", "study.toml"}, 1,
                 "plans 8 runs, fewer than the 800 releases of each member");
  write_text_file(folder / "study.toml",
                  replaced(study(), "use = \"fit\"", "use = \"fit\"\nblock = \"ball\""));
  write_text_file(folder / "stops.csv", "x,y,block\n17,1,ball\n19,0,ball\n22,-1,ball\n");
  expect_refused(folder, {"calibrate", "study.toml"}, 1, "has no block \"ball\"; it has bar, cube");
}

}  // namespace
}  // namespace clast
