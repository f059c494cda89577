/// `clast reconstruct` on folders of photographs: what is taken for one, and what is refused.
#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
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

TEST(PhotoCommand, ABoardIsReadAndLookedFor) {
  const ScratchFolder folder;
  write_photos(folder / "B01", true);
  const auto said = [&](const std::string& board, int code,
                        const std::vector<std::string>& more = {}) {
    write_text_file(folder / "board.toml", board);
    std::vector<std::string> arguments = {"reconstruct", "B01", "--board", "board.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = run_clast(arguments, folder.path());
    EXPECT_EQ(run.exit_code, code) << run.err;
    return run.err;
  };
  const std::string head = "dictionary = \"4x4_50\"\n";
  const std::string markers =
      "[[marker]]\nid = 0\ncentre_m = [0, 0]\n[[marker]]\nid = 1\ncentre_m = [0.6, 0, 0.1]\n";
  const std::string charuco =
      "[charuco]\ncolumns = 7\nrows = 5\nsquare_m = 0.04\nmarker_m = 0.03\n";
  EXPECT_TRUE(contains(said(head + markers, 1), "no two of the board"));
  EXPECT_TRUE(contains(said(head + charuco, 1), "0 of its corners were found"));
  EXPECT_TRUE(contains(said(head + markers, 2, {"--markers", "5x5_100"}),
                       "5x5_100 contradicts board.toml, whose markers are 4x4_50"));

  EXPECT_TRUE(contains(said(head, 1), "board.toml: board: 0 markers"));
}

}  // namespace
}  // namespace clast
