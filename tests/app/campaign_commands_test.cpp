// terrain, simulate and compare as processes, on a slope of two zones made here.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "terrain/terrain_input.hpp"
#include "tests/app/slope_campaign.hpp"
#include "tests/study/hand_made_results.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

using Campaigns = SlopeCampaign;

TEST_F(Campaigns, RunFromTerrainToReport) {
  const ProgramRun terrain = run_clast(
      {"terrain", "slope.obj", "flat.obj", "--zones", "slope,flat", "-o", "t.h5", "--json"},
      folder.path());
  ASSERT_EQ(terrain.exit_code, 0) << terrain.err;
  const Json report = Json::parse(terrain.out);
  EXPECT_EQ(report["triangles"], 4);
  EXPECT_NEAR(report["zones"][0]["plan_area_m2"], 400.0, 1e-9);
  EXPECT_NEAR(report["high_m"][2], 20.0, 1e-9);

  const ProgramRun dry = run_clast({"simulate", "campaign.toml", "--dry-run"}, folder.path());
  ASSERT_EQ(dry.exit_code, 0) << dry.err;
  EXPECT_TRUE(contains(dry.out, "8 runs")) << dry.out;
  EXPECT_TRUE(contains(dry.out, "k_n, N/m") && contains(dry.out, "k_r, N m/rad")) << dry.out;
  EXPECT_TRUE(contains(dry.out, "\ncube ") && contains(dry.out, "\nbar ")) << dry.out;
  EXPECT_FALSE(fs::exists(folder / "results.h5"));
  EXPECT_TRUE(contains(dry.out, "for 8 runs on") && contains(dry.out, "judging by")) << dry.out;
  const std::string map = read_text_file(folder / "results.map.svg");
  EXPECT_TRUE(map.starts_with("<?xml") && contains(map, "release point 1") && contains(map, "B1"));
  EXPECT_FALSE(contains(map, "Stops"));

  for (const std::string threads : {"1", "2"}) {
    const ProgramRun run = run_clast(
        {"simulate", "campaign.toml", "-o", threads + ".h5", "--threads", threads, "--json"},
        folder.path());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json summary = Json::parse(run.out);
    EXPECT_EQ(summary["runs"], 8);
    std::size_t stopped = 0;
    for (const auto& [reason, count] : summary["stop_reasons"].items()) {
      stopped += count.get<std::size_t>();
    }
    EXPECT_EQ(stopped, 8u);
    EXPECT_EQ(summary["stop_reasons"]["error"], 0);
    EXPECT_EQ(summary["below_ground"], 0);
    const ProgramRun compared =
        run_clast({"compare", threads + ".h5", "-o", "out" + threads}, folder.path());
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    EXPECT_TRUE(compared.out.ends_with("report.html\n")) << compared.out;
  }
  for (const char* table : {"runs.csv", "barriers.csv", "crossings.csv", "deposits.csv"}) {
    EXPECT_EQ(read_text_file(folder / "out1" / table), read_text_file(folder / "out2" / table));
  }
  EXPECT_TRUE(fs::exists(folder / "out1" / "report.html"));
  EXPECT_FALSE(fs::exists(folder / "1.h5.part"));
}

// Each of the two blocks with its own, and the same when it is alone.
TEST_F(Campaigns, DryRunListsTheStiffnessOfEveryBlock) {
  const auto stiffness = [&](const std::string& text) {
    write_text_file(folder / "campaign.toml", text);
    const ProgramRun run =
        run_clast({"simulate", "campaign.toml", "--dry-run", "--json"}, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(run.out)["stiffness"];
  };
  const std::string both = slope_campaign();
  const std::string alone = replaced(both, "[terrain]", "select = [\"cube\"]\n[terrain]");
  const Json blocks = stiffness(both);
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0]["block"], "bar");
  EXPECT_EQ(blocks[1]["block"], "cube");
  EXPECT_NE(blocks[0]["stiffness_n_m"], blocks[1]["stiffness_n_m"]);
  const BlockLibrary library = BlockLibrary::read(folder / "blocks.h5");
  for (const Json& row : blocks) {
    const Block& block = library.find_block(row["block"].get<std::string>());
    // Rest decides here: m g/(e_n^2 d) with d = 2 % of S.
    const double normal = block.mass.mass * 9.81 / (0.01 * 0.02 * block.axes().S);
    EXPECT_NEAR(row["stiffness_n_m"][0].get<double>(), normal, 1e-9 * normal);
    EXPECT_NEAR(row["rest_depth_m"][1].get<double>(), 0.02 * block.axes().S, 1e-9);
  }
  EXPECT_EQ(stiffness(alone), Json::array({blocks[1]}));
}

TEST_F(Campaigns, CompareGroupsAnimatesAndHoldsAgainstMeasuredStops) {
  std::string text =
      replaced(slope_campaign(), "trajectory_interval_s = 0", "trajectory_interval_s = 0.1");
  text = replaced(text, "max_time_s = 5", "max_time_s = 20");
  text = replaced(text, "[blocks]\n", "[blocks]\nscale = \"equal-mass\"\n");
  write_text_file(folder / "campaign.toml", text);
  const ProgramRun run = run_clast({"simulate", "campaign.toml", "-o", "r.h5"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  write_text_file(folder / "seen.csv", "x,y\n20,0\n22,1\n");
  const ProgramRun compared = run_clast({"compare", "r.h5", "-o", "out", "--by", "point", "--by",
                                         "mass_kg", "--animate", "2", "--measured", "seen.csv"},
                                        folder.path());
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_FALSE(contains(compared.err, "mass differs")) << compared.err;
  for (const char* file :
       {"impacts.csv", "differences.csv", "profiles.csv", "measured.csv", "rasters/E_95.tif",
        "animation/animation.pvd", "animation/terrain_1.vtp", "stops.gpkg", "report.html"}) {
    EXPECT_TRUE(fs::exists(folder / "out" / file)) << file;
    EXPECT_TRUE(contains(compared.out, file) || contains(file, "terrain_1")) << file;
  }
  EXPECT_TRUE(contains(read_text_file(folder / "out/deposits.csv"), "\npoint 1,"));
  const ProgramRun effects =
      run_clast({"compare", "r.h5", "--summary", "--effects"}, folder.path());
  EXPECT_EQ(effects.exit_code, 0) << effects.err;
  EXPECT_TRUE(contains(effects.out, "of the runout's variance")) << effects.out;
  EXPECT_TRUE(contains(read_text_file(folder / "out/effects.csv"), "\n1,runout,"));
  expect_refused(folder, {"compare", "r.h5", "-o", "bad", "--by", "colour"}, 1, "colour");
  expect_refused(folder, {"compare", "r.h5", "-o", "bad", "--measured", "none.csv"}, 1, "none.csv");
  // The same map again with nothing to animate.
  write_text_file(folder / "campaign.toml", slope_campaign());
  ASSERT_EQ(run_clast({"simulate", "campaign.toml", "-o", "q.h5"}, folder.path()).exit_code, 0);
  const ProgramRun still =
      run_clast({"compare", "q.h5", "-o", "still", "--animate", "2"}, folder.path());
  EXPECT_EQ(still.exit_code, 1);
  EXPECT_TRUE(contains(still.err, "trajectory_interval_s")) << still.err;
}

TEST_F(Campaigns, FinishedResultsAreKeptAndNotRunAgain) {
  const auto simulate = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"simulate", "campaign.toml", "-o", "r.h5"};
    words.insert(words.end(), more.begin(), more.end());
    return run_clast(words, folder.path());
  };
  ASSERT_EQ(simulate({}).exit_code, 0);
  const std::string first = read_text_file(folder / "r.h5");
  expect_refused(folder, {"simulate", "campaign.toml", "-o", "r.h5"}, 1,
                 "r.h5: already exists; --replace replaces it");
  const ProgramRun again = simulate({"--resume"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(contains(again.out, "r.h5: nothing to do, all runs are stored already")) << again.out;
  EXPECT_EQ(read_text_file(folder / "r.h5"), first);
  EXPECT_EQ(simulate({"--replace"}).exit_code, 0);
  write_text_file(folder / "campaign.toml", slope_campaign() + "# another one\n");
  expect_refused(folder, {"simulate", "campaign.toml", "-o", "r.h5", "--resume"}, 1,
                 "r.h5: holds the finished results of another campaign file; --replace replaces");
}

TEST_F(Campaigns, WhatAnInterruptedCampaignLeftIsNotThrownAway) {
  write_text_file(folder / "results.h5.part", "runs of yesterday");
  expect_refused(folder, {"simulate", "campaign.toml"}, 1, "--resume");
  EXPECT_EQ(read_text_file(folder / "results.h5.part"), "runs of yesterday");
  expect_refused(folder, {"simulate", "campaign.toml", "--resume"}, 1, "results.h5.part");
}

// A block that goes wrong is hard to find, so the results are written by hand and joined.
TEST_F(Campaigns, RunsThatEndedWithAnErrorMakeTheCommandFail) {
  const auto store = [&](const std::string& file, std::size_t failed) {
    CampaignResults results = hand_made_results();
    results.release_sets = {""};
    results.set_of_point = {0};
    results.ground_sets = {{"", 0, results.ground}};
    ResultsWriter writer = ResultsWriter::create(folder / file, results);
    for (RunRecord run : results.runs) {
      if (run.run >= results.runs.size() - failed) {
        run.result.stop_reason = StopReason::kError;
        run.result.message = "the motion is no longer finite at 1.5 s";
      }
      StoredRun stored;
      stored.record = run;
      writer.add(stored);
    }
    writer.finish();
  };
  store("bad.h5", 2);
  const ProgramRun bad =
      run_clast({"simulate", "--merge", "bad.h5", "-o", "all.h5"}, folder.path());
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_TRUE(contains(bad.err,
                       "2 of 6 runs failed with an error; first error: run 4: the motion is no "
                       "longer finite at 1.5 s"))
      << bad.err;
  EXPECT_TRUE(contains(bad.err, "all.h5") && contains(bad.err, "time_step_s")) << bad.err;
  EXPECT_TRUE(fs::exists(folder / "all.h5")) << "what was run is kept";
  store("good.h5", 0);
  const ProgramRun good =
      run_clast({"simulate", "--merge", "good.h5", "-o", "all.h5", "--replace"}, folder.path());
  EXPECT_EQ(good.exit_code, 0) << good.err;
}

TEST_F(Campaigns, MistakesInTheCampaignFileAreNamed) {
  expect_refused(folder, {"simulate", "none.toml"}, 1, "none.toml");
  write_text_file(folder / "red.toml", slope_campaign("colour = \"red\"\n"));
  expect_refused(folder, {"simulate", "red.toml"}, 1, "colour");
  expect_refused(folder, {"simulate", "red.toml", "--dry-run"}, 1, "colour");
  refuse_campaign("", "blocks");
  refuse_campaign("[blocks\n", "bad.toml");
  refuse_campaign(slope_campaign("colour = \"red\"\n"), "colour");
  refuse_campaign(replaced(slope_campaign(), "friction = 0.4", "friction = -0.4"), "-0.4");
  refuse_campaign(replaced(slope_campaign(), "[ground.flat]", "[ground.flot]"), "fl");
  refuse_campaign(replaced(slope_campaign(), "[[5, 0, 0], [5, 3, 0]]", "[[5, 0, 0], [90, 3, 0]]"),
                  "90");
  refuse_campaign(replaced(slope_campaign(), "blocks.h5", "stones.h5"), "stones.h5");
  refuse_campaign(replaced(slope_campaign(), "flat.obj", "flot.obj"), "flot.obj");
  refuse_campaign(replaced(slope_campaign(), "\"blocks.h5\"", "\"blocks.h5\"\nselect = [\"ball\"]"),
                  "ball");
}

TEST_F(Campaigns, DamagedInputsAreNamed) {
  const std::string whole = read_text_file(folder / "blocks.h5");
  write_text_file(folder / "cut.h5", whole.substr(0, whole.size() / 2));
  refuse_campaign(replaced(slope_campaign(), "blocks.h5", "cut.h5"), "cut.h5");
  write_text_file(folder / "text.obj", "no ground\n");
  refuse_campaign(replaced(slope_campaign(), "flat.obj", "text.obj"), "text.obj");
}

TEST_F(Campaigns, TerrainRefusesWhatIsNoGround) {
  write_text_file(folder / "empty.obj", "");
  write_text_file(folder / "prose.stl", "no ground\n");
  write_text_file(folder / "nan.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n");
  for (const std::string file : {"none.obj", "empty.obj", "prose.stl", "nan.obj"}) {
    const std::string said = refusal<Error>([&] { read_terrain({.surface = {folder / file}}); });
    EXPECT_TRUE(contains(said, file));
  }
  expect_refused(folder, {"terrain", "none.obj", "-o", "t.h5"}, 1, "none.obj");
  // As many names as files: anything else is a misuse or a failure, but never a guess.
  const ProgramRun run = run_clast(
      {"terrain", "slope.obj", "flat.obj", "--zones", "a,b,c", "-o", "t.h5"}, folder.path());
  EXPECT_TRUE(run.exit_code == 1 || run.exit_code == 2) << run.exit_code;
  EXPECT_TRUE(contains(run.err, "zone")) << run.err;
  EXPECT_FALSE(fs::exists(folder / "t.h5"));
}

TEST_F(Campaigns, CompareRefusesWhatIsNoResult) {
  write_text_file(folder / "text.h5", "run,block\n");
  write_text_file(folder / "empty.h5", "");
  for (const std::string file : {"none.h5", "empty.h5", "text.h5", "blocks.h5"}) {
    EXPECT_TRUE(contains(refusal<Error>([&] { read_results(folder / file); }), file));
  }
  expect_refused(folder, {"compare", "text.h5", "-o", "out"}, 1, "text.h5");
}

TEST_F(Campaigns, SayWhatEachOfSeveralMassesIs) {
  std::string text = slope_campaign(
      "[contact.blocks]\nenergy_restitution = 0.01\nfriction = 0.7\nrolling_friction = 0.2\n");
  const std::size_t begin = text.find("[release]");
  text.replace(begin, text.find("[[barrier]]") - begin,
               "[[mass]]\nname = \"upper\"\npolygon = [[5, -2], [9, -2], [9, 2], [5, 2]]\n"
               "settle = true\nrealisations = 2\n"
               "[[mass]]\nname = \"lower\"\npolygon = [[12, -2], [14, -2], [14, 2], [12, 2]]\n"
               "release_time_s = 2.5\n");
  text = replaced(text, "[terrain]", "draw = { count = 9 }\n[terrain]");
  write_text_file(folder / "masses.toml", text);
  const ProgramRun dry = run_clast({"simulate", "masses.toml", "--dry-run"}, folder.path());
  ASSERT_EQ(dry.exit_code, 0) << dry.err;
  for (const char* part : {"18 runs: 18 blocks, 2 realisations of 9 blocks in 2 masses\n",
                           "mass upper, released at 0 s: 6 blocks, ", " %, before they settle\n",
                           "mass lower, released at 2.5 s: 3 blocks, "}) {
    EXPECT_TRUE(contains(dry.out, part)) << dry.out;
  }
  const ProgramRun json =
      run_clast({"simulate", "masses.toml", "--dry-run", "--json"}, folder.path());
  const Json masses = Json::parse(json.out)["masses"];
  ASSERT_EQ(masses.size(), 4u);
  EXPECT_EQ(masses[0]["name"], "upper");
  EXPECT_EQ(masses[0]["blocks"], 6);
  EXPECT_EQ(masses[3]["name"], "lower");
  EXPECT_EQ(masses[3]["blocks"], 3);
  EXPECT_EQ(masses[3]["release_time_s"], 2.5);
  EXPECT_NEAR(masses[3]["area_m2"], 8.0, 1.0);
  const ProgramRun run = run_clast({"simulate", "masses.toml", "-o", "m.h5"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const ProgramRun compared =
      run_clast({"compare", "m.h5", "-o", "out", "--by", "release_set"}, folder.path());
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  const std::string runs = read_text_file(folder / "out" / "runs.csv");
  EXPECT_TRUE(contains(runs, ",upper,") && contains(runs, ",lower,"));
  const ProgramRun scenes =
      run_clast({"export", "masses.toml", "--to", "rockable", "-o", "scenes"}, folder.path());
  EXPECT_EQ(scenes.exit_code, 1);
  EXPECT_TRUE(contains(scenes.err, "its masses settle behind confining walls first")) << scenes.err;
}

}  // namespace
}  // namespace clast
