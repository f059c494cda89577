// One campaign by threads, by processes, in shards, and interrupted: always the same results.
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/app/mpi_run.hpp"
#include "tests/app/slope_campaign.hpp"

namespace clast {
namespace {

class SharedCampaign : public SlopeCampaign {
 protected:
  void SetUp() override {
    SlopeCampaign::SetUp();
    std::string text = replaced(slope_campaign(), "random = 2, seed = 4 }",
                                "random = 40, seed = 4 }\nvelocity_m_s = [3, 0, 0]");
    text = replaced(text, "trajectory_interval_s = 0", "trajectory_interval_s = 0.02");
    text = replaced(text, "max_time_s = 5", "max_time_s = 0.5");
    text = replaced(text, "from = [12, -9]\nto = [12, 9]", "from = [5.5, -9]\nto = [5.5, 9]");
    write_text_file(folder / "campaign.toml", text);
  }
  void vary_blocks() {
    const std::string text = read_text_file(folder / "campaign.toml");
    write_text_file(folder / "campaign.toml",
                    replaced(text, "[terrain]",
                             "select = [\"bar\"]\n"
                             "vary = { to = [[0.8, 0.6]], reference = \"ellipsoid\" }\n[terrain]"));
  }
  /// Enough runs that a kill finds some of them undone, on a fast or busy machine too.
  void make_many_runs() {
    const std::string text = read_text_file(folder / "campaign.toml");
    write_text_file(folder / "campaign.toml", replaced(text, "random = 40", "random = 400"));
  }
  /// In two realisations that take long enough to be killed within.
  void let_blocks_stay() {
    std::string text = read_text_file(folder / "campaign.toml");
    text = replaced(text, "random = 40, seed = 4 }",
                    "random = 1, seed = 4, fresh = true }\nsequence = \"stay\"\nrealisations = 2");
    text = replaced(text, "[terrain]", "draw = { count = 5 }\n[terrain]");
    text +=
        "[contact]\ntime_step_s = 3e-6\n"
        "[contact.blocks]\nenergy_restitution = 0.1\nfriction = 0.5\nrolling_friction = 0.2\n";
    write_text_file(folder / "campaign.toml", text);
  }
  std::string run(const std::vector<std::string>& arguments) {
    const ProgramRun run = run_clast(arguments, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  }
  // One HDF5 library writes equal datasets to equal bytes (docs/formats.md).
  void expect_same_as_one(const std::string& file) {
    ASSERT_TRUE(fs::exists(folder / file)) << file;
    run({"simulate", "campaign.toml", "-o", "one.h5", "--threads", "1"});
    EXPECT_TRUE(read_text_file(folder / file) == read_text_file(folder / "one.h5")) << file;
    EXPECT_FALSE(fs::exists(partial_file(file)));
    run({"compare", file, "-o", "out-" + file});
    run({"compare", "one.h5", "-o", "out-one.h5"});
    for (const char* table : {"runs.csv", "barriers.csv", "crossings.csv", "deposits.csv"}) {
      EXPECT_EQ(read_text_file(folder / ("out-" + file) / table),
                read_text_file(folder / "out-one.h5" / table))
          << file << " " << table;
    }
  }
  fs::path partial_file(const std::string& file) const { return folder / (file + ".part"); }
};

TEST_F(SharedCampaign, IsTheSameOnTwoThreads) {
  run({"simulate", "campaign.toml", "-o", "two.h5", "--threads", "2"});
  expect_same_as_one("two.h5");
}

TEST_F(SharedCampaign, IsTheSameInFourShardsJoined) {
  for (const std::string shard : {"3/4", "1/4", "4/4", "2/4"}) {
    run({"simulate", "campaign.toml", "-o", "all.h5", "--shard", shard, "--threads", "1"});
  }
  EXPECT_FALSE(fs::exists(folder / "all.h5"));
  expect_refused(folder, {"simulate", "--merge", "all.1of4.h5", "all.3of4.h5", "-o", "all.h5"}, 1,
                 "80 of 160 runs are in none of the parts, run 1 first");
  expect_refused(
      folder, {"simulate", "--merge", "all.1of4.h5", "all.2of4.h5", "all.1of4.h5", "-o", "all.h5"},
      1, "run 0 is in");
  expect_refused(folder, {"compare", "all.1of4.h5", "all.3of4.h5", "-o", "out"}, 1, "--merge");
  run({"simulate", "--merge", "all.2of4.h5", "all.1of4.h5", "all.4of4.h5", "all.3of4.h5", "-o",
       "all.h5"});
  expect_same_as_one("all.h5");
}

TEST_F(SharedCampaign, OfVariedBlocksIsTheSameInShardsJoined) {
  vary_blocks();
  for (const std::string shard : {"2/2", "1/2"}) {
    run({"simulate", "campaign.toml", "-o", "all.h5", "--shard", shard, "--threads", "1"});
  }
  run({"simulate", "--merge", "all.1of2.h5", "all.2of2.h5", "-o", "all.h5"});
  expect_same_as_one("all.h5");
}

TEST_F(SharedCampaign, OfVariedBlocksIsTheSameOnTwoThreads) {
  vary_blocks();
  run({"simulate", "campaign.toml", "-o", "two.h5", "--threads", "2"});
  expect_same_as_one("two.h5");
}

TEST_F(SharedCampaign, OfVariedBlocksIsWhatVaryThenSimulateGives) {
  run({"vary", "blocks.h5", "bar", "--to", "0.8,0.6", "--reference", "ellipsoid", "-o", "s.h5"});
  const std::string text = read_text_file(folder / "campaign.toml");
  write_text_file(folder / "two.toml", replaced(text, "blocks.h5", "s.h5"));
  run({"simulate", "two.toml", "-o", "two.h5"});
  run({"compare", "two.h5", "-o", "two"});
  vary_blocks();
  run({"check", "campaign.toml"});
  EXPECT_TRUE(
      contains(run({"simulate", "campaign.toml", "--dry-run"}), "2 bodies made of 1 block"));
  const auto plan =
      nlohmann::json::parse(run({"simulate", "campaign.toml", "--dry-run", "--json"}));
  EXPECT_EQ(plan["varied_blocks"], nlohmann::json({"bar"}));
  EXPECT_EQ(plan["blocks"], nlohmann::json({"bar_ellipsoid", "bar_il0.8_sl0.6"}));
  run({"simulate", "campaign.toml", "-o", "one.h5"});
  run({"compare", "one.h5", "-o", "one"});
  for (const char* table : {"runs.csv", "barriers.csv", "crossings.csv", "deposits.csv"}) {
    EXPECT_EQ(read_text_file(folder / "one" / table), read_text_file(folder / "two" / table))
        << table;
  }
  EXPECT_TRUE(contains(read_text_file(folder / "one/runs.csv"), "\"stretch to 0.8, 0.6\""));
}

TEST_F(SharedCampaign, ShardsOfDifferentCampaignsAreNotJoined) {
  run({"simulate", "campaign.toml", "-o", "all.h5", "--shard", "1/2"});
  const std::string text = read_text_file(folder / "campaign.toml");
  write_text_file(folder / "campaign.toml", replaced(text, "max_time_s = 0.5", "max_time_s = 0.4"));
  run({"simulate", "campaign.toml", "-o", "all.h5", "--shard", "2/2"});
  expect_refused(folder, {"simulate", "--merge", "all.1of2.h5", "all.2of2.h5"}, 1,
                 "all.2of2.h5: belongs to another campaign");
  expect_refused(folder, {"simulate", "--merge", "blocks.h5"}, 1, "blocks.h5");
  expect_refused(folder, {"simulate", "--merge", "none.h5"}, 1, "none.h5");
}

TEST_F(SharedCampaign, IsTheSameAfterThreeKills) {
  make_many_runs();
  std::uintmax_t size = 0;
  for (int kill = 0; kill < 3; ++kill) {
    std::vector<std::string> words =
        clast_words({"simulate", "campaign.toml", "-o", "cut.h5", "--threads", "1"});
    if (kill > 0) words.push_back("--resume");
    RunningProgram program(words, folder.path());
    // Until a few runs more are in the journal.
    std::error_code code;
    while (!program.ended() && !(fs::exists(partial_file("cut.h5")) &&
                                 fs::file_size(partial_file("cut.h5"), code) > size + 50'000)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    program.signal(SIGKILL);
    ASSERT_EQ(program.wait().exit_code, 128 + SIGKILL) << "kill " << kill << " came too late";
    size = fs::file_size(partial_file("cut.h5"));
  }
  run({"simulate", "campaign.toml", "-o", "cut.h5", "--threads", "2", "--resume"});
  expect_same_as_one("cut.h5");
}

TEST_F(SharedCampaign, WhoseBlocksStayIsTheSameAfterKillsWithinARealisation) {
  let_blocks_stay();
  std::string checkpoint;
  for (int kill = 0; kill < 3; ++kill) {
    std::vector<std::string> words =
        clast_words({"simulate", "campaign.toml", "-o", "cut.h5", "--threads", "1",
                     "--checkpoint-interval", "0.01"});
    if (kill > 0) words.push_back("--resume");
    RunningProgram program(words, folder.path());
    const fs::path file = folder / "cut.h5.part.1";
    std::string now;
    while (!program.ended() && (now.empty() || now == checkpoint)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (fs::exists(file)) now = read_text_file(file);
    }
    program.signal(SIGKILL);
    ASSERT_EQ(program.wait().exit_code, 128 + SIGKILL) << "kill " << kill << " came too late";
    checkpoint = read_text_file(file);
  }
  run({"simulate", "campaign.toml", "-o", "cut.h5", "--threads", "2", "--resume"});
  expect_same_as_one("cut.h5");
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    EXPECT_FALSE(entry.path().filename().string().starts_with("cut.h5.")) << entry.path();
  }
}

TEST_F(SharedCampaign, WhoseBlocksStayGoesOnWithinARealisationAfterCtrlC) {
  let_blocks_stay();
  std::vector<std::string> words = clast_words({"simulate", "campaign.toml", "-o", "cut.h5",
                                                "--threads", "1", "--checkpoint-interval", "0"});
  for (const int signal : {SIGINT, SIGHUP}) {  // Ctrl-C, then a terminal that is closed
    RunningProgram program(words, folder.path());
    while (!program.ended() && !fs::exists(partial_file("cut.h5"))) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    program.wait_for_handler(signal);  // the file of the first round is there from the start
    program.signal(signal);
    const ProgramRun stopped = program.wait();
    EXPECT_EQ(stopped.exit_code, 1) << signal;
    EXPECT_TRUE(contains(
        stopped.err,
        signal == SIGHUP
            ? "clast: interrupted; "
            : "0 of 10 runs and the checkpoints of "
              "unfinished realisations are kept. Continue with: clast simulate campaign.toml -o "
              "cut.h5 --resume"))
        << stopped.err;
    EXPECT_TRUE(fs::exists(folder / "cut.h5.part.1"));
    words.push_back("--resume");
  }
  std::string damaged = read_text_file(folder / "cut.h5.part.1");
  const std::string whole = damaged;
  damaged[damaged.size() / 2] ^= 1;
  write_text_file(folder / "cut.h5.part.1", damaged);
  expect_refused(folder, {"simulate", "campaign.toml", "-o", "cut.h5", "--resume"}, 1,
                 "cut.h5.part.1: is damaged; delete it");
  write_text_file(folder / "cut.h5.part.1", whole);
  run({"simulate", "campaign.toml", "-o", "cut.h5", "--resume"});
  expect_same_as_one("cut.h5");
}

TEST_F(SharedCampaign, IsTheSameAfterCtrlC) {
  make_many_runs();
  RunningProgram program(
      clast_words({"simulate", "campaign.toml", "-o", "cut.h5", "--threads", "1"}), folder.path());
  while (!program.ended() && !fs::exists(partial_file("cut.h5"))) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.signal(SIGINT);
  const ProgramRun stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 1);
  EXPECT_TRUE(contains(stopped.err,
                       "of 1600 runs are kept. Continue with: clast simulate "
                       "campaign.toml -o cut.h5 --resume"))
      << stopped.err;
  EXPECT_TRUE(fs::exists(partial_file("cut.h5")));
  run({"simulate", "campaign.toml", "-o", "cut.h5", "--resume"});
  expect_same_as_one("cut.h5");
}

TEST_F(SharedCampaign, JournalOfAShardIsNotResumedAsAnother) {
  make_many_runs();
  RunningProgram program(
      clast_words({"simulate", "campaign.toml", "-o", "s.h5", "--shard", "1/2", "--threads", "1"}),
      folder.path());
  while (!program.ended() && !(fs::exists(partial_file("s.1of2.h5")) &&
                               fs::file_size(partial_file("s.1of2.h5")) > 20'000)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.signal(SIGKILL);
  program.wait();
  fs::rename(partial_file("s.1of2.h5"), partial_file("s.2of2.h5"));
  expect_refused(folder, {"simulate", "campaign.toml", "-o", "s.h5", "--shard", "2/2", "--resume"},
                 1, "was begun with other runs than shard 2 of 2");
}

#ifdef CLAST_MPIRUN
class SharedByMpi : public SharedCampaign {};

TEST_F(SharedByMpi, IsTheSameOnTwoProcesses) {
  const ProgramRun run = mpirun("2", {"simulate", "campaign.toml", "-o", "mpi.h5"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  // Said once, not by every process.
  EXPECT_EQ(run.out.find("160 runs"), run.out.rfind("160 runs")) << run.out;
  EXPECT_TRUE(contains(run.out, "mpi.h5: written")) << run.out;
  expect_same_as_one("mpi.h5");
}

TEST_F(SharedByMpi, OfVariedBlocksIsTheSameOnTwoProcesses) {
  vary_blocks();
  const ProgramRun run = mpirun("2", {"simulate", "campaign.toml", "-o", "mpi.h5"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  expect_same_as_one("mpi.h5");
}

TEST_F(SharedByMpi, RefusalsEndAllProcesses) {
  const ProgramRun missing = mpirun("2", {"simulate", "none.toml"}, folder.path());
  EXPECT_NE(missing.exit_code, 0);
  EXPECT_EQ(missing.err.find("none.toml"), missing.err.rfind("none.toml")) << missing.err;
  EXPECT_TRUE(contains(missing.err, "clast: ")) << missing.err;
  // What only the process that writes can notice.
  fs::create_directory(folder / "taken.h5");
  const ProgramRun taken =
      mpirun("2", {"simulate", "campaign.toml", "-o", "taken.h5"}, folder.path());
  EXPECT_NE(taken.exit_code, 0);
  EXPECT_TRUE(contains(taken.err, "taken.h5: is a folder")) << taken.err;
}
#endif

}  // namespace
}  // namespace clast
