/// The run of colmap, with a script in its place: what is kept, what is refused, and how it ends.
#include "reconstruct/photos/colmap_run.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "core/files/text_file.hpp"
#include "tests/support/plain_photo.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

/// A script that is called as colmap is. `mapper` is what it does then, with $out the folder for
/// models; every call is written to calls.txt.
class FakeColmap {
 public:
  explicit FakeColmap(const std::string& mapper, const std::string& other = ":") {
    write_text_file(folder_ / "colmap",
                    "#!/bin/sh\necho $1 >>" + (folder_ / "calls.txt").string() +
                        "\necho \"$@\" >>" + (folder_ / "words.txt").string() +
                        "\nwhile [ $# -gt 0 ]; do [ \"$1\" = --ImageReader.mask_path ] && "
                        "ls -R $2 >>" +
                        (folder_ / "words.txt").string() +
                        "; [ \"$1\" = --output_path ] && out=$2; "
                        "[ \"$1\" = mapper ] && mapper=1; shift; done\n"
                        "if [ -n \"$mapper\" ]; then\n" +
                        mapper + "\nelse\n" + other + "\nfi\n");
    std::filesystem::permissions(folder_ / "colmap", std::filesystem::perms::owner_all);
    std::filesystem::create_directories(photos());
    for (int i = 0; i < 10; ++i) {
      write_plain_photo(photos() / ("p" + std::to_string(i) + ".bmp"), 16, 12,
                        static_cast<unsigned>(i));
    }
  }
  std::filesystem::path photos() const { return folder_ / "photos"; }
  ColmapOptions options() const {
    return {.program = (folder_ / "colmap").string(), .cache = folder_ / "cache"};
  }
  PhotoModel cameras() const { return run_colmap(photos(), options()); }
  std::size_t calls() const {
    const std::string text = read_text_file(folder_ / "calls.txt");
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }

  /// All that it was called with, and the masks that it was given.
  std::string words() const { return read_text_file(folder_ / "words.txt"); }

  /// Shell text that writes a model of the photos from `first` to `last` as group `number`.
  static std::string group(int number, int first, int last) {
    const std::string at = "$out/" + std::to_string(number);
    std::string text = "mkdir -p " + at + "; echo '1 SIMPLE_RADIAL 16 12 20 8 6 0' >" + at +
                       "/cameras.txt; : >" + at + "/points3D.txt; : >" + at + "/images.txt\n";
    for (int i = first; i <= last; ++i) {
      text += "echo '" + std::to_string(i + 1) + " 1 0 0 0 0 0 1 1 p" + std::to_string(i) +
              ".bmp' >>" + at + "/images.txt; echo >>" + at + "/images.txt\n";
    }
    return text;
  }

 private:
  ScratchFolder folder_;
};

TEST(ColmapRun, AMissingProgramIsToldWithThePackageThatGivesIt) {
  const FakeColmap fake(":");
  ColmapOptions options = fake.options();
  options.program = "no-such-colmap";
  const std::string text = refusal([&] { run_colmap(fake.photos(), options); });
  EXPECT_TRUE(contains(text, "apt-get install colmap"));
  EXPECT_TRUE(contains(text, "`model`"));
}

TEST(ColmapRun, CamerasAreKeptByTheContentOfThePhotos) {
  const FakeColmap fake(FakeColmap::group(0, 0, 8));
  const PhotoModel model = fake.cameras();
  EXPECT_EQ(model.photos.size(), 9u);
  EXPECT_EQ(model.photos_without_pose, 1u);
  EXPECT_EQ(model.photos[3].file, fake.photos() / "p3.bmp");
  EXPECT_EQ(fake.calls(), 3u);  // features, matches, cameras
  EXPECT_EQ(fake.cameras().photos.size(), 9u);
  EXPECT_EQ(fake.calls(), 3u);
  write_plain_photo(fake.photos() / "p9.bmp", 16, 12, 77);
  EXPECT_EQ(fake.cameras().photos.size(), 9u);
  EXPECT_EQ(fake.calls(), 6u);
}

TEST(ColmapRun, MasksAreHandedOnByColmapsNamesAndTheirContentCounts) {
  const FakeColmap fake(FakeColmap::group(0, 0, 9));
  ColmapOptions options = fake.options();
  options.masks = fake.photos() / "masks";  // among the photos, but none of them
  std::filesystem::create_directories(options.masks);
  for (int i = 0; i < 10; ++i) {
    write_plain_photo(options.masks / ("p" + std::to_string(i) + ".bmp"), 16, 12, 5);
  }
  EXPECT_EQ(run_colmap(fake.photos(), options).photos_without_pose, 0u);
  EXPECT_TRUE(contains(fake.words(), "p9.bmp.png"));
  EXPECT_EQ(fake.calls(), 3u);
  run_colmap(fake.photos(), options);
  EXPECT_EQ(fake.calls(), 3u);
  write_plain_photo(options.masks / "p3.bmp", 16, 12, 6);
  run_colmap(fake.photos(), options);
  EXPECT_EQ(fake.calls(), 6u);
}

TEST(ColmapRun, NothingButTheModelIsLeftInTheCache) {
  const FakeColmap fake(FakeColmap::group(0, 0, 9));
  fake.cameras();
  std::size_t entries = 0;
  for (const auto& entry : std::filesystem::directory_iterator(fake.options().cache)) {
    EXPECT_TRUE(std::filesystem::exists(entry.path() / "images.txt"));
    ++entries;
  }
  EXPECT_EQ(entries, 1u);
  const FakeColmap failing("exit 1");
  EXPECT_FALSE(refusal([&] { failing.cameras(); }).empty());
  EXPECT_TRUE(std::filesystem::is_empty(failing.options().cache));
}

TEST(ColmapRun, PhotosThatShareNothingAreToldWithWhatToDo) {
  const FakeColmap fake("echo '=> No good initial image pair found.'; exit 1");
  const std::string text = refusal([&] { fake.cameras(); });
  EXPECT_TRUE(contains(text, "0 of 10 photos could be placed"));
  EXPECT_TRUE(contains(text, "every 10-15 degrees"));
}

TEST(ColmapRun, GroupsThatDoNotHangTogetherAreCounted) {
  const FakeColmap fake(FakeColmap::group(0, 0, 3) + FakeColmap::group(1, 4, 9 - 1));
  const std::string text = refusal([&] { fake.cameras(); });
  EXPECT_TRUE(contains(text, "the 10 photos fall into 2 separate groups (5 and 4 photos)"));
}

TEST(ColmapRun, ASideThatIsMissingIsToldAgainAndFromTheCacheToo) {
  const FakeColmap fake(FakeColmap::group(0, 0, 4));
  EXPECT_TRUE(contains(refusal([&] { fake.cameras(); }), "5 of 10 photos could be placed"));
  const FakeColmap enough(FakeColmap::group(0, 0, 5));
  EXPECT_EQ(enough.cameras().photos.size(), 6u);
  ColmapOptions strict = enough.options();
  strict.min_posed_fraction = 0.9;
  EXPECT_TRUE(contains(refusal([&] { run_colmap(enough.photos(), strict); }),
                       "6 of 10 photos could be placed"));
}

TEST(ColmapRun, WhatItSaidLastIsPassedOn) {
  const FakeColmap fake(":", "echo 'error: no room on the disk' >&2; exit 3");
  EXPECT_TRUE(contains(refusal([&] { fake.cameras(); }),
                       "colmap feature_extractor failed; it said: error: no room on the disk"));
}

TEST(ColmapRun, ItIsEndedWithAllItStartedWhenItsTimeIsOver) {
  const ScratchFolder scratch;
  const std::string mark = (scratch / "mark").string();
  const FakeColmap fake(":", "(sleep 2; echo late >" + mark + ") & sleep 60");
  ColmapOptions options = fake.options();
  options.time_limit = 0.3;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(contains(refusal([&] { run_colmap(fake.photos(), options); }),
                       "colmap feature_extractor was stopped after"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  ::usleep(2500000);
  EXPECT_FALSE(std::filesystem::exists(mark));
}

TEST(ColmapRun, TooFewPhotosAreRefused) {
  const ScratchFolder folder;
  write_plain_photo(folder / "a.bmp", 16, 12, 1);
  EXPECT_TRUE(
      contains(refusal([&] { run_colmap(folder.path()); }), "1 photos are too few for a block"));
}

}  // namespace
}  // namespace clast
