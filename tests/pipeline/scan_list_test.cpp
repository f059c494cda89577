// Which scans a list of files and folders names, and how their blocks are called.
#include "pipeline/scan_list.hpp"

#include <gtest/gtest.h>

#include "tests/library/block_samples.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scan_files.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

class ScanList : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"east", "west", "deep/east"}) fs::create_directories(folder / name);
  }

  void add(const std::string& name) { write_obj(folder / name, cuboid(1, 0.8, 0.6)); }

  std::vector<std::string> ids(std::vector<std::string> inputs) {
    for (std::string& input : inputs) input = (folder / input).string();
    std::vector<std::string> found;
    for (const ScanFile& scan : list_scans(inputs)) found.push_back(scan.id);
    return found;
  }

  ScratchFolder folder;
};

using Ids = std::vector<std::string>;

TEST_F(ScanList, AFolderWithoutMeshesIsRefused) {
  write_text_file(folder / "west" / "notes.txt", "no mesh");
  const std::string text = refusal([&] { ids({"west"}); });
  EXPECT_TRUE(contains(text, (folder / "west").string() + ": this folder holds neither"));
}

TEST_F(ScanList, AFolderGivesEveryMeshInItOnce) {
  add("deep/b.obj");
  add("deep/east/a.obj");
  EXPECT_EQ(ids({"deep", "deep/b.obj"}), Ids({"b", "a"}));
}

TEST_F(ScanList, SharedStemsTakeTheirFoldersName) {
  add("east/scan.obj");
  add("west/scan.obj");
  add("deep/east/scan.obj");
  EXPECT_EQ(ids({"east/scan.obj", "west/scan.obj"}), Ids({"east_scan", "west_scan"}));
  EXPECT_TRUE(contains(refusal([&] {
                         ids({"east/scan.obj", "deep/east/scan.obj"});
                       }),
                       "east_scan"));
}

// "images" says that there are pictures, not of what.
TEST_F(ScanList, PhotographsTakeTheNameOfTheBlockTheyAreOf) {
  const auto photos = [&](const std::string& name) {
    for (const char* file : {"1.jpg", "2.jpg", "3.jpg"}) write_text_file(folder / name / file, "");
  };
  photos("east/B017/images");
  photos("east/B018/DCIM/raw");
  photos("east/B019");
  photos("west/B017/Photos");
  EXPECT_EQ(ids({"east/B017/images"}), Ids({"B017"}));
  EXPECT_EQ(ids({"east/B017/images/"}), Ids({"B017"}));
  EXPECT_EQ(ids({"east/B017"}), Ids({"B017"}));
  EXPECT_EQ(ids({"east"}), Ids({"B017", "B018", "B019"}));
  EXPECT_EQ(ids({"east", "west"}), Ids({"east_B017", "B018", "B019", "west_B017"}));
  const fs::path here = fs::current_path();
  fs::current_path(folder / "east" / "B017" / "images");
  EXPECT_EQ(list_scans({"."}).front().id, "B017");
  fs::current_path(here);
}

TEST_F(ScanList, OneScanInTwoFormatsIsTwoBlocksWithTheirExtensions) {
  add("east/scan.obj");
  write_text_file(folder / "east" / "scan.off", "OFF\n");
  fs::create_directory(folder / "east" / ".hidden");
  add("east/.hidden/deleted.obj");
  EXPECT_EQ(ids({"east"}), Ids({"east_scan_obj", "east_scan_off"}));
}

}  // namespace
}  // namespace clast
