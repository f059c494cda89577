// clast reconstruct on many scans: folders, names, jobs, and going on where it stopped.
#include <nlohmann/json.hpp>

#include "tests/app/command_support.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/cut_mesh.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

class ScanBatch : public testing::Test {
 protected:
  ScratchFolder folder;
};

TEST_F(ScanBatch, AFolderWithoutMeshesIsRefused) {
  fs::create_directory(folder / "scans");
  write_text_file(folder / "scans" / "notes.txt", "no mesh");
  expect_refused(folder, {"reconstruct", "scans"}, 1, "scans: ");
  expect_refused(folder, {"reconstruct", "scans"}, 1, "no mesh");
}

TEST_F(ScanBatch, AFolderGivesEveryMeshInItOnce) {
  fs::create_directories(folder / "scans" / "east");
  write_obj(folder / "scans" / "b.obj", cuboid(1, 0.8, 0.6));
  write_obj(folder / "scans" / "east" / "a.obj", cuboid(1, 0.8, 0.5));
  const ProgramRun run =
      run_clast({"reconstruct", "scans", "scans/b.obj", "--json"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json json = Json::parse(run.out);
  ASSERT_EQ(json["blocks"].size(), 2u);
  EXPECT_EQ(json["blocks"][0]["id"], "b");
  EXPECT_EQ(json["blocks"][1]["id"], "a");
}

TEST_F(ScanBatch, SharedStemsTakeTheirFoldersName) {
  for (const char* name : {"east", "west", "deep"}) fs::create_directories(folder / name);
  fs::create_directories(folder / "deep" / "east");
  write_obj(folder / "east" / "scan.obj", cuboid(1, 0.8, 0.6));
  write_obj(folder / "west" / "scan.obj", cuboid(1, 0.8, 0.5));
  write_obj(folder / "deep" / "east" / "scan.obj", cuboid(1, 0.7, 0.5));
  const ProgramRun run =
      run_clast({"reconstruct", "east/scan.obj", "west/scan.obj", "--json"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["blocks"][0]["id"], "east_scan");
  EXPECT_EQ(Json::parse(run.out)["blocks"][1]["id"], "west_scan");
  expect_refused(folder, {"reconstruct", "east/scan.obj", "deep/east/scan.obj", "-o", "two.h5"}, 1,
                 "east_scan");
}

TEST_F(ScanBatch, OneScanInTwoFormatsIsTwoBlocksWithTheirExtensions) {
  fs::create_directories(folder / "east" / ".hidden");
  write_obj(folder / "east" / "scan.obj", cuboid(1, 0.8, 0.6));
  write_text_file(folder / "east" / "scan.off",
                  "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  write_obj(folder / "east" / ".hidden" / "deleted.obj", cuboid(1, 0.7, 0.5));
  const ProgramRun run = run_clast({"reconstruct", "east", "--json"}, folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json blocks = Json::parse(run.out)["blocks"];
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[0]["id"], "east_scan_obj");
  EXPECT_EQ(blocks[1]["id"], "east_scan_off");
}

TEST_F(ScanBatch, JobsGiveTheSameOutputInTheSameOrder) {
  fs::create_directory(folder / "scans");
  for (int i = 0; i < 7; ++i) {
    // The first ones take longest, so that side by side the others are done before them.
    write_obj(folder / "scans" / ("b" + std::to_string(i) + ".obj"),
              cuboid(1, 0.9 - 0.05 * i, 0.5));
  }
  write_text_file(folder / "scans" / "b3.obj", "v 0 0 0\n");
  std::vector<ProgramRun> runs;
  for (const char* jobs : {"1", "4"}) {
    runs.push_back(run_clast(
        {"reconstruct", "scans", "-o", std::string(jobs) + ".h5", "--jobs", jobs, "--json"},
        folder.path()));
    EXPECT_EQ(runs.back().exit_code, 1);
    EXPECT_TRUE(contains(runs.back().err, "scans/b3.obj: "));
    EXPECT_TRUE(contains(runs.back().err, "1 of 7 scans gave no block; the reasons are above"));
  }
  EXPECT_EQ(runs[0].out, runs[1].out);
  EXPECT_EQ(read_text_file(folder / "1.h5"), read_text_file(folder / "4.h5"));
}

TEST_F(ScanBatch, ResumeSkipsWhatIsThereOfTheSameFileAndOptions) {
  write_obj(folder / "a.obj", cuboid(1, 0.9, 0.5));
  write_obj(folder / "b.obj", cuboid(1, 0.8, 0.5));
  const std::vector<std::string> command = {"reconstruct", "a.obj", "b.obj", "--resume"};
  ASSERT_EQ(run_clast({"reconstruct", "a.obj"}, folder.path()).exit_code, 0);
  const ProgramRun second = run_clast(command, folder.path());
  EXPECT_EQ(second.exit_code, 0) << second.err;
  EXPECT_TRUE(contains(second.out,
                       "1 scan skipped, in the library already with the same file and options"));
  EXPECT_TRUE(contains(second.out, "1 block written, 2 in all"));
  const std::string library = read_text_file(folder / "blocks.h5");
  const ProgramRun third = run_clast(command, folder.path());
  EXPECT_EQ(third.exit_code, 0) << third.err;
  EXPECT_TRUE(contains(third.out, "2 scans skipped"));
  EXPECT_FALSE(contains(third.out, "written"));
  EXPECT_EQ(read_text_file(folder / "blocks.h5"), library);
  // Another option or another file is no longer the same.
  std::vector<std::string> denser = command;
  denser.insert(denser.end(), {"--density", "2700"});
  expect_refused(folder, denser, 1, "2 of 2 scans gave no block");
  expect_refused(folder, denser, 1,
                 "block a is in blocks.h5 already, made with other options; use --replace");
  write_obj(folder / "b.obj", cuboid(1, 0.7, 0.5));
  expect_refused(folder, command, 1, "block b is in blocks.h5 already, made of another file");
  std::vector<std::string> replaced = command;
  replaced.push_back("--replace");
  const ProgramRun fourth = run_clast(replaced, folder.path());
  EXPECT_TRUE(contains(fourth.out, "1 scan skipped"));
  EXPECT_TRUE(contains(fourth.out, "1 block written, 2 in all"));
}

TEST_F(ScanBatch, ANameThatIsNoIdCostsThatScanAlone) {
  fs::create_directory(folder / "scans");
  write_obj(folder / "scans" / "two\nlines.obj", cuboid(1, 0.9, 0.8));
  write_obj(folder / "scans" / "fine.obj", cuboid(1, 0.9, 0.8));
  const ProgramRun run = run_clast({"reconstruct", "scans"}, folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.out, "1 block written, 1 in all")) << run.out;
  EXPECT_FALSE(contains(run.out, "lines: ")) << run.out;
  EXPECT_TRUE(contains(run.err, "line break")) << run.err;
}

}  // namespace
}  // namespace clast
