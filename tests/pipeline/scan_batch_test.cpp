// Many scans into one library: jobs, names, going on where it stopped, and being stopped.
#include "pipeline/scan_batch.hpp"

#include <gtest/gtest.h>

#include <mutex>

#include "core/files/text_file.hpp"
#include "library/block_library.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/cut_mesh.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/rocks_on_ground.hpp"
#include "tests/support/scan_files.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

/// Keeps what is said of a batch.
class Log : public ScanBatchObserver {
 public:
  void on_block_made(const Block& block, const BlockOrigin&) override {
    const std::lock_guard lock(mutex_);
    made_blocks.insert(block.id);
  }
  void on_block_added(const Block& block) override { said.push_back("added " + block.id); }
  void on_block_retained(const Block& block) override { said.push_back("kept " + block.id); }
  void on_scan_failed(const ScanFile& scan, const std::string& reason) override {
    said.push_back("failed " + scan.id + ": " + reason);
  }
  void on_note(const std::string& text) override { said.push_back("noted " + text); }

  std::vector<std::string> said;
  std::set<std::string> made_blocks;

 private:
  std::mutex mutex_;
};

class Batches : public testing::Test {
 protected:
  void SetUp() override { options.library = folder / "blocks.h5"; }

  fs::path scan(const std::string& name, const TriangleMesh& mesh) {
    write_obj(folder / name, mesh);
    return folder / name;
  }

  ScanBatchResult run(const std::vector<ScanFile>& scans, const ProgressCallback& progress = {}) {
    log.said.clear();
    return reconstruct_scan_batch(scans, options, log, progress);
  }

  std::size_t stored() const { return BlockLibrary::read(options.library).blocks().size(); }

  ScratchFolder folder;
  ScanBatchOptions options;
  Log log;
};

TEST_F(Batches, JobsGiveTheSameLibraryAndTheSameReportsInTheSameOrder) {
  std::vector<ScanFile> scans;
  for (int i = 0; i < 7; ++i) {
    // The first ones take longest, so that side by side the others are done before them.
    const std::string id = "b" + std::to_string(i);
    scans.push_back({scan(id + ".obj", cuboid(1, 0.9 - 0.05 * i, 0.5)), id, {}});
  }
  write_text_file(folder / "b3.obj", "v 0 0 0\n");
  std::vector<std::vector<std::string>> said;
  for (const unsigned jobs : {1u, 4u}) {
    options.jobs = jobs;
    options.library = folder / (std::to_string(jobs) + ".h5");
    const ScanBatchResult result = run(scans);
    EXPECT_EQ(result.added, 6u);
    EXPECT_EQ(result.blocks, 6u);
    EXPECT_EQ(result.failed_scans, 1u);
    said.push_back(log.said);
  }
  ASSERT_EQ(said[0].size(), 7u);
  EXPECT_TRUE(said[0][3].starts_with("failed b3: ")) << said[0][3];
  EXPECT_EQ(said[0], said[1]);
  EXPECT_EQ(log.made_blocks.size(), 6u);
  EXPECT_EQ(read_text_file(folder / "1.h5"), read_text_file(folder / "4.h5"));
}

TEST_F(Batches, ResumeSkipsWhatIsThereOfTheSameFileAndOptions) {
  const std::vector<ScanFile> both = {{scan("a.obj", cuboid(1, 0.9, 0.5)), "a", {}},
                                      {scan("b.obj", cuboid(1, 0.8, 0.5)), "b", {}}};
  run({both[0]});
  options.resume = true;
  const ScanBatchResult second = run(both);
  EXPECT_EQ(log.said, (std::vector<std::string>{"kept a", "added b"}));
  EXPECT_EQ(second.skipped, 1u);
  const std::string library = read_text_file(options.library);
  EXPECT_EQ(run(both).skipped, 2u);
  EXPECT_EQ(read_text_file(options.library), library);
  // Another option or another file is no longer the same.
  options.scan.block.density = 2700.0;
  EXPECT_EQ(run(both).failed_scans, 2u);
  EXPECT_TRUE(contains(log.said[0], "already, made with other options; use `replace`"));
  options.scan.block.density = BlockOptions().density;
  scan("b.obj", cuboid(1, 0.7, 0.5));
  EXPECT_EQ(run(both).failed_scans, 1u);
  EXPECT_TRUE(contains(log.said[1], "already, made from another file"));
  options.replace = true;
  const ScanBatchResult fourth = run(both);
  EXPECT_EQ(fourth.skipped, 1u);
  EXPECT_EQ(fourth.added, 1u);
  EXPECT_EQ(fourth.blocks, 2u);
}

TEST_F(Batches, ANameThatIsNoIdCostsThatScanAlone) {
  const fs::path path = scan("a.obj", cuboid(1, 0.9, 0.8));
  run({{path, "two\nlines", {}}, {path, "fine", {}}});
  ASSERT_EQ(log.said.size(), 2u);
  EXPECT_TRUE(contains(log.said[0], "line break"));
  EXPECT_EQ(log.said[1], "added fine");
}

TEST_F(Batches, WhatWasDoneIsKeptWhenABatchIsCancelled) {
  std::vector<ScanFile> scans;
  for (const char* id : {"a", "b", "c"}) {
    scans.push_back({scan(std::string(id) + ".obj", cuboid(1, 0.9, 0.8)), id, {}});
  }
  const ProgressCallback cancel = [](const ProgressUpdate& step) {
    EXPECT_EQ(step.total, 3u);
    EXPECT_EQ(step.done, step.activity.back() == 'a' ? 0u : step.activity.back() == 'b' ? 1u : 2u);
    if (step.activity == "reading c") throw Cancelled();
  };
  EXPECT_THROW(run(scans, cancel), Cancelled);
  EXPECT_EQ(log.said, (std::vector<std::string>{"added a", "added b"}));
  EXPECT_EQ(stored(), 2u);
  options.resume = true;
  EXPECT_EQ(run(scans).skipped, 2u);
}

TEST_F(Batches, OneBlockOfASplitThatIsThereAlreadyCostsNeitherTheOthersNorTheBatch) {
  const std::vector<ScanFile> scans = {{scan("scene.obj", two_rocks_on_ground()), "scene", {}},
                                       {scan("cube.obj", cuboid(1, 0.9, 0.8)), "cube", {}}};
  run({{folder / "cube.obj", "scene_2", {}}});
  options.scan.split = true;
  options.scan.vertices = 60;
  const ScanBatchResult result = run(scans);
  EXPECT_EQ(result.failed_scans, 1u);
  EXPECT_EQ(result.blocks, 3u);
  ASSERT_EQ(log.said.size(), 4u);
  EXPECT_TRUE(contains(log.said[0], "noted scene: scan of "));
  EXPECT_TRUE(contains(log.said[2], "block scene_2 is in the library already"));
  // A split into fewer than before leaves the others, and says so.
  scan("scene.obj", cuboid(1, 0.9, 0.8));
  options.replace = true;
  run({scans[0]});
  ASSERT_EQ(log.said.size(), 2u);
  EXPECT_TRUE(contains(log.said[1], "still holds block scene_2 of an earlier split"));
}

TEST_F(Batches, FinishedBlocksOfASplitAreKeptWhenItIsCancelled) {
  const std::vector<ScanFile> scans = {{scan("scene.obj", two_rocks_on_ground()), "scene", {}}};
  options.scan.split = true;
  options.scan.vertices = 60;
  options.scan.block.threads = 1;
  const ProgressCallback cancel = [](const ProgressUpdate& step) {
    if (step.activity == "simplifying scene_2") throw Cancelled();
  };
  EXPECT_THROW(run(scans, cancel), Cancelled);
  EXPECT_EQ(stored(), 1u);
  const Block first = BlockLibrary::read(options.library).find_block("scene_1");
  ASSERT_TRUE(first.deposit);
  EXPECT_EQ(first.deposit->blocks, 2u);
  options.resume = true;
  EXPECT_EQ(run(scans).added, 1u);
  EXPECT_EQ(stored(), 2u);
  EXPECT_EQ(run(scans).skipped, 1u);
  const Block again = BlockLibrary::read(options.library).find_block("scene_1");
  EXPECT_EQ(again.mass.volume, first.mass.volume);
}

TEST_F(Batches, EditsAreThoseOfOneScan) {
  const fs::path path = scan("scene.obj", two_rocks_on_ground());
  options.scan.split = true;
  options.scan.edits = {{DepositEditKind::kDrop, {Vec3::Zero()}}};
  EXPECT_TRUE(contains(refusal([&] {
                         run({{path, "a", {}}, {path, "b", {}}});
                       }),
                       "`edits` are for a single scan, but 2 scans are given"));
}

TEST_F(Batches, StationsAreThoseOfOneScan) {
  const fs::path path = scan("scene.obj", two_rocks_on_ground());
  options.scan.split = true;
  options.scan.stations = {Vec3::Zero()};
  EXPECT_TRUE(contains(refusal([&] {
                         run({{path, "a", {}}, {path, "b", {}}});
                       }),
                       "`stations` are those of a single scan, but 2 scans are given"));
}

TEST_F(Batches, TheLabelledCloudReplacesNeitherTheScanNorOtherFiles) {
  const fs::path path = scan("scene.ply", two_rocks_on_ground());
  options.scan.split = true;
  options.scan.labelled = folder / "." / "scene.ply";
  options.replace = true;
  const auto refused = [&] { return refusal([&] { run({{path, "a", {}}}); }); };
  EXPECT_TRUE(contains(refused(), "is the scan and would be overwritten; give another name"));
  write_text_file(folder / "notes.txt", "notes\n");
  options.scan.labelled = folder / "notes.txt";
  EXPECT_TRUE(contains(refused(), "so it is not replaced"));
  write_text_file(folder / "labelled.ply", "ply\n");
  options.scan.labelled = folder / "labelled.ply";
  options.replace = false;
  EXPECT_TRUE(contains(refused(), "`replace` replaces it"));
}

TEST_F(Batches, AMassIsThatOfOneBlock) {
  const fs::path path = scan("a.obj", cuboid(1, 0.9, 0.8));
  options.scan.block.mass = 1500.0;
  const std::string text = refusal([&] { run({{path, "a", {}}, {path, "b", {}}}); });
  EXPECT_TRUE(contains(text, "`mass` is the mass of a single block, but 2 scans are given"));
  EXPECT_EQ(run({{path, "a", {}}}).added, 1u);
}

TEST_F(Batches, WithoutAnObserverTheReasonsOfAllFailuresAreThrown) {
  write_text_file(folder / "a.obj", "v 0 0 0\n");
  const std::vector<ScanFile> scans = {{folder / "a.obj", "a", {}},
                                       {folder / "none.obj", "none", {}},
                                       {scan("c.obj", cuboid(1, 0.9, 0.8)), "c", {}}};
  const std::string text = refusal([&] { reconstruct_scan_batch(scans, options); });
  EXPECT_TRUE(contains(text, "a.obj") && contains(text, "none.obj"));
  EXPECT_EQ(stored(), 1u);
}

}  // namespace
}  // namespace clast
