/// `clast reconstruct` on folders of photographs: what is taken for one, and what is refused.
#include <gtest/gtest.h>

#include "core/text_file.hpp"
#include "tests/support/plain_photo.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/run_program.hpp"

namespace clast {
namespace {

/// Photos of nothing, with cameras all round as COLMAP writes them.
void write_photos(const std::filesystem::path& folder, bool with_cameras) {
  std::filesystem::create_directories(folder);
  std::string images;
  for (int i = 0; i < 4; ++i) {
    const std::string name = "p" + std::to_string(i) + ".bmp";
    write_plain_photo(folder / name, 64, 48, static_cast<unsigned>(i));
    images += std::to_string(i + 1) + " 1 0 0 0 0 0 1 1 " + name + "\n\n";
  }
  if (!with_cameras) return;
  write_text_file(folder / "cameras.txt", "1 PINHOLE 64 48 60 60 32 24\n");
  write_text_file(folder / "images.txt", images);
}

TEST(PhotoCommand, AFolderOfPhotosIsOneScanAndColmapIsAskedFor) {
  const ScratchFolder folder;
  write_photos(folder / "B01", false);
  const ProgramRun run =
      run_clast({"reconstruct", "B01", "--colmap", "no-such-colmap", "--photo-cache", "cache"},
                folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "apt-get install colmap"));
  EXPECT_FALSE(std::filesystem::exists(folder / "blocks.h5"));
}

TEST(PhotoCommand, FoldersOfPhotosInAFolderAreOneScanEach) {
  const ScratchFolder folder;
  write_photos(folder / "site/B01/images", false);
  write_photos(folder / "site/B02", false);
  const ProgramRun run =
      run_clast({"reconstruct", "site", "--colmap", "no-such-colmap", "--photo-cache", "cache"},
                folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "site/B01"));
  EXPECT_TRUE(contains(run.err, "site/B02"));
  EXPECT_TRUE(contains(run.err, "2 of 2 scans gave no block"));
}

TEST(PhotoCommand, WithoutAScaleNoBlockIsMade) {
  const ScratchFolder folder;
  write_photos(folder / "B01", true);
  const ProgramRun run = run_clast({"reconstruct", "B01"}, folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "no scale"));
  EXPECT_TRUE(contains(run.err, "--allow-unscaled"));
}

TEST(PhotoCommand, MarkersThatAreNotThereAreTold) {
  const ScratchFolder folder;
  write_photos(folder / "B01", true);
  const ProgramRun run = run_clast({"reconstruct", "B01", "--marker-size", "0.2"}, folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "no marker was found"));
}

TEST(PhotoCommand, CamerasThatLookAtNothingAreTold) {
  const ScratchFolder folder;
  write_photos(folder / "B01", true);
  const ProgramRun run = run_clast({"reconstruct", "B01", "--allow-unscaled"}, folder.path());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(contains(run.err, "look along parallel lines"));
}

TEST(PhotoCommand, WhatIsNoScaleBarIsAMisuse) {
  const ScratchFolder folder;
  write_photos(folder / "B01", true);
  for (const char* bar : {"0,1", "0,1,0", "0,0,1.5", "0.5,1,2", "a,b,c", "0,1,-2", "0,1,2,3"}) {
    const ProgramRun run = run_clast({"reconstruct", "B01", "--scale-bar", bar}, folder.path());
    EXPECT_EQ(run.exit_code, 2) << bar;
    EXPECT_TRUE(contains(run.err, "--scale-bar"));
  }
}

}  // namespace
}  // namespace clast
