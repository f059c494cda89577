// clast reconstruct on many scans: what it prints of them.
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/app/command_support.hpp"
#include "tests/library/block_samples.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

class ScanBatch : public testing::Test {
 protected:
  ScratchFolder folder;
};

TEST_F(ScanBatch, AFolderIsReadAndOneBadScanCostsNoOther) {
  fs::create_directory(folder / "scans");
  for (const char* name : {"a.obj", "c.obj"}) {
    write_obj(folder / "scans" / name, cuboid(1, 0.8, 0.5));
  }
  write_text_file(folder / "scans" / "b.obj", "v 0 0 0\n");
  const ProgramRun lines =
      run_clast({"reconstruct", "scans", "-o", "l.h5", "--jobs", "2"}, folder.path());
  EXPECT_EQ(lines.exit_code, 1);
  EXPECT_TRUE(contains(lines.err, "scans/b.obj: "));
  EXPECT_TRUE(contains(lines.err, "1 of 3 scans gave no block; the reasons are above"));
  EXPECT_TRUE(contains(lines.out, "2 blocks written, 2 in all"));
  const ProgramRun json = run_clast({"reconstruct", "scans", "--json"}, folder.path());
  const Json blocks = Json::parse(json.out)["blocks"];
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0]["id"], "a");
  EXPECT_EQ(blocks[1]["id"], "c");
  EXPECT_EQ(Json::parse(json.out)["failed"][0]["scan"], "scans/b.obj");
  fs::create_directory(folder / "empty");
  expect_refused(folder, {"reconstruct", "empty"}, 1, "holds neither a mesh");
}

TEST_F(ScanBatch, ResumeSaysWhatItSkipped) {
  write_obj(folder / "a.obj", cuboid(1, 0.9, 0.5));
  write_obj(folder / "b.obj", cuboid(1, 0.8, 0.5));
  ASSERT_EQ(run_clast({"reconstruct", "a.obj"}, folder.path()).exit_code, 0);
  std::vector<std::string> command = {"reconstruct", "a.obj", "b.obj", "--resume"};
  const ProgramRun second = run_clast(command, folder.path());
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_TRUE(contains(
      second.out,
      "1 scan skipped: already in the library, made from the same file with the same options"));
  EXPECT_TRUE(contains(second.out, "1 block written, 2 in all"));
  const ProgramRun third = run_clast(command, folder.path());
  EXPECT_TRUE(contains(third.out, "2 scans skipped"));
  EXPECT_FALSE(contains(third.out, "written"));
  command.insert(command.end(), {"--density", "2700"});
  expect_refused(folder, command, 1,
                 "block a is in blocks.h5 already, made with other options; use --replace");
}

TEST_F(ScanBatch, CtrlCKeepsWhatIsFinished) {
  fs::create_directory(folder / "scans");
  for (int i = 10; i < 22; ++i) {
    write_obj(folder / "scans" / ("b" + std::to_string(i) + ".obj"), cuboid(1, 0.9, 0.8));
  }
  const std::vector<std::string> command = {"reconstruct", "scans", "--report", "pages",
                                            "--resume"};
  RunningProgram program(clast_words(command), folder.path());
  // A page is written when its block is finished.
  while (!program.ended() && !fs::exists(folder / "pages" / "blocks" / "b10.html")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.signal(SIGINT);
  const ProgramRun stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 1);
  EXPECT_TRUE(
      contains(stopped.err, "clast: interrupted; waiting for the current step of each scan"))
      << "at once, before the step ends";
  EXPECT_TRUE(contains(stopped.err,
                       "clast: interrupted; finished blocks are in blocks.h5. To continue, repeat "
                       "the command with --resume"));
  const ProgramRun rest = run_clast(command, folder.path());
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_TRUE(contains(rest.out, "skipped: already in the library"));
  EXPECT_TRUE(contains(rest.out, "written, 12 in all"));
}

}  // namespace
}  // namespace clast
