// The programs of samples/deposit as others run them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/refusal.hpp"
#include "tests/support/run_program.hpp"

namespace clast {
namespace {

class DepositPrograms : public testing::Test {
 protected:
  ProgramRun run(std::vector<std::string> words) {
    return RunningProgram(std::move(words), folder_.path()).wait();
  }
  ScratchFolder folder_;
};

TEST_F(DepositPrograms, TheTruthOfADepositScoresOne) {
  const ProgramRun made = run({CLAST_MAKE_DEPOSIT, "d", "--kind", "natural", "--blocks", "3",
                               "--size-ratio", "2", "--bodies"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_TRUE(contains(made.out, "3 blocks of 3 at rest, 3 seen, 3 eligible"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "d/bodies/3.ply"));
  EXPECT_TRUE(read_text_file(folder_ / "d/stations.csv").starts_with("x_m,y_m,z_m\n"));
  // blocks.csv has the columns that are scored: sizes without any error.
  const ProgramRun scored =
      run({CLAST_SCORE_DEPOSIT, "d", "d/truth.ply", "--bodies", "d/blocks.csv"});
  ASSERT_EQ(scored.exit_code, 0) << scored.err;
  const nlohmann::json score = nlohmann::json::parse(scored.out);
  EXPECT_EQ(score["precision"], 1.0);
  EXPECT_EQ(score["recall"], 1.0);
  EXPECT_EQ(score["close_fraction"], 1.0);
  EXPECT_EQ(score["blocks"].size(), 3u);
  EXPECT_EQ(score["bodies"]["L_m"]["count"], 3);
  EXPECT_EQ(score["bodies"]["L_m"]["median_absolute_error"], 0.0);
  EXPECT_EQ(score["bodies_by_visible_fraction"].size(), 4u);
}

TEST_F(DepositPrograms, MisuseAndMissingFilesAreRefused) {
  EXPECT_EQ(run({CLAST_MAKE_DEPOSIT}).exit_code, 2);
  const ProgramRun strange = run({CLAST_MAKE_DEPOSIT, "d", "--kind", "pile"});
  EXPECT_EQ(strange.exit_code, 1);
  EXPECT_TRUE(contains(strange.err, "\"pile\" is unknown"));
  EXPECT_EQ(run({CLAST_SCORE_DEPOSIT, "d"}).exit_code, 2);
  const ProgramRun missing = run({CLAST_SCORE_DEPOSIT, "d", "truth.ply"});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_TRUE(contains(missing.err, "truth.ply"));
}

}  // namespace
}  // namespace clast
