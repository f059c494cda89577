// The paper's whole study, 2,048 runs: how long it takes, that none is lost, and that threads,
// processes, shards and kills do not change a bit. CLAST_STUDY_ORIENTATIONS makes it smaller, for a
// look at the test itself.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "study/results/results.hpp"
#include "tests/app/mpi_run.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/support/run_program.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kOrientations = 64;

std::size_t orientations() {
  const char* fewer = std::getenv("CLAST_STUDY_ORIENTATIONS");
  return fewer ? std::strtoul(fewer, nullptr, 10) : kOrientations;
}

/// CPU time of all programs run and waited for, s.
double cpu_time() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

class AuthumeStudy : public testing::Test {
 protected:
  void SetUp() override {
    const std::vector<std::array<std::string, 3>> blocks = {{"SP1A", "0.027", "343.5"},
                                                            {"SP2A", "0.049", "1472.5"},
                                                            {"SP2B", "0.006", "1767.5"},
                                                            {"SP3A", "0.005", "514.0"}};
    for (const auto& [id, radius, mass] : blocks) {
      run({"reconstruct", test_data("authume/blocks/" + id + ".stl").string(), "-o", "authume.h5",
           "--core", "--radius", radius, "--mass", mass});
    }
    std::istringstream published(read_text_file(test_data("authume/drop/orientations.txt")));
    std::string some, line;
    for (std::size_t i = 0; i <= orientations() && std::getline(published, line); ++i) {
      some += line + "\n";
    }
    write_text_file(folder / "orientations.txt", some);
    const auto data = fs::absolute(test_data("authume")).parent_path();
    ::setenv("CLAST_DATA", data.c_str(), 1);
    for (const std::string profile : {"p1", "p2"}) {
      std::string text = read_text_file(std::string(CLAST_SOURCE_DIR) +
                                        "/samples/authume/campaign-" + profile + ".toml");
      replace(text, "../../out/authume.h5", "authume.h5");
      replace(text, "${CLAST_DATA}/authume/drop/orientations.txt", "orientations.txt");
      write_text_file(folder / (profile + ".toml"), text);
    }
  }
  static void replace(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  }
  void run(const std::vector<std::string>& arguments) {
    const ProgramRun done = run_clast(arguments, folder.path());
    ASSERT_EQ(done.exit_code, 0) << done.err;
  }
  std::vector<std::string> simulate(const std::string& profile, const std::string& output,
                                    const std::vector<std::string>& more) {
    std::vector<std::string> words = {"simulate", profile + ".toml", "-o", output};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// Equal bytes of the table.
  std::string runs_csv_of(const std::string& file) {
    run({"compare", file, "-o", "out-" + file});
    return read_text_file(folder / ("out-" + file) / "runs.csv");
  }
  struct Duration {
    double wall = 0.0, cpu = 0.0;  ///< s
  };
  Duration timed(const std::string& name, const std::vector<std::string>& more) {
    const double cpu = cpu_time();
    const auto begin = std::chrono::steady_clock::now();
    for (const std::string profile : {"p1", "p2"}) {
      run(simulate(profile, name + "-" + profile + ".h5", more));
    }
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    return {wall.count(), cpu_time() - cpu};
  }
  /// Kills it three times on its way, then lets it end.
  void kill_and_resume(const std::string& profile, std::uintmax_t whole) {
    const std::string output = "cut-" + profile + ".h5";
    const fs::path part = folder / (output + ".part");
    std::uintmax_t size = 0;  // of the journal when it was killed last
    for (int kill = 0; kill < 3; ++kill) {
      std::vector<std::string> more = {"--threads", "2"};
      if (kill > 0) more.push_back("--resume");
      RunningProgram program(clast_words(simulate(profile, output, more)), folder.path());
      std::error_code code;
      while (!program.ended() &&
             !(fs::exists(part) && fs::file_size(part, code) > size + whole / 16)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
      program.signal(SIGKILL);
      ASSERT_EQ(program.wait().exit_code, 128 + SIGKILL) << "the kill came too late";
      size = fs::file_size(part);
    }
    run(simulate(profile, output, {"--threads", "2", "--resume"}));
  }
  ScratchFolder folder;
};

TEST_F(AuthumeStudy, IsQuickCompleteAndAlwaysTheSame) {
  const Duration one = timed("one", {"--threads", "1"});
  const Duration two = timed("two", {"--threads", "2"});
  double load = 0.0;
  ::getloadavg(&load, 1);
  std::printf(
      "1 thread: %.0f s (CPU %.0f s), 2 threads: %.0f s (CPU %.0f s), ratio %.2f, load %.1f\n",
      one.wall, one.cpu, two.wall, two.cpu, two.wall / one.wall, load);
  EXPECT_LE(two.wall, 0.6 * one.wall) << "with two idle cores; the load average was " << load;
  EXPECT_LT(two.wall, 300.0) << "with two idle cores; the load average was " << load;

  for (const std::string profile : {"p1", "p2"}) {
    const CampaignResults results = read_results(folder / ("one-" + profile + ".h5"));
    ASSERT_EQ(results.runs.size(), 16 * orientations());
    for (const RunRecord& stored : results.runs) {
      EXPECT_NE(stored.result.stop_reason, StopReason::kError)
          << profile << " run " << stored.run << ": " << stored.result.message;
      EXPECT_FALSE(stored.result.below_ground) << profile << " run " << stored.run;
    }
    const std::string expected = runs_csv_of("one-" + profile + ".h5");
    EXPECT_TRUE(runs_csv_of("two-" + profile + ".h5") == expected) << profile << ": 2 threads";
    std::vector<std::string> join = {"simulate", "-o", "all-" + profile + ".h5", "--merge"};
    for (const std::string shard : {"2", "4", "1", "3"}) {
      run(simulate(profile, "all-" + profile + ".h5", {"--shard", shard + "/4"}));
      join.push_back("all-" + profile + "." + shard + "of4.h5");
    }
    run(join);
    EXPECT_TRUE(runs_csv_of("all-" + profile + ".h5") == expected) << profile << ": 4 shards";
    kill_and_resume(profile, fs::file_size(folder / ("one-" + profile + ".h5")));
    EXPECT_TRUE(runs_csv_of("cut-" + profile + ".h5") == expected) << profile << ": 3 kills";
#ifdef CLAST_MPIRUN
    const ProgramRun shared =
        mpirun("2", simulate(profile, "mpi-" + profile + ".h5", {}), folder.path());
    ASSERT_EQ(shared.exit_code, 0) << shared.err;
    EXPECT_TRUE(runs_csv_of("mpi-" + profile + ".h5") == expected) << profile << ": mpirun";
#endif
  }
}

}  // namespace
}  // namespace clast
