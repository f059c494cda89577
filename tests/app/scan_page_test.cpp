// The pages of clast reconstruct --report in a real browser: what a reader sees of them.
#include "tests/app/browser.hpp"
#include "tests/app/scan_page_probe.hpp"
#include "tests/support/samples_folder.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

class ScanPage : public testing::Test {
 protected:
  void SetUp() override { expect_browser(); }
  Json seen(const fs::path& path) { return probed(path, kScanPageProbe, folder); }
  ScratchFolder folder;
};

TEST_F(ScanPage, ShowsTheScanBeforeAndAfterAndTheSummarySorts) {
  std::vector<std::string> arguments = {
      "reconstruct", (kSamples / "dirty").string(), "--vertices", "150", "--report", "pages"};
  ASSERT_EQ(run_clast(arguments, folder.path()).exit_code, 0);
  const Json page = seen(folder / "pages" / "blocks" / "D01_ground_patch.html");
  ASSERT_FALSE(page.is_null()) << "the page can't be drawn";
  // As read, the same around the block, closed, deviation.
  ASSERT_EQ(page["strips"].size(), 4u);
  for (const Json& strip : page["strips"]) {
    EXPECT_EQ(strip["views"], 3);
    EXPECT_GT(double(strip["rock"]), 5000.0) << strip;
  }
  EXPECT_GT(double(page["strips"][0]["red"]), 100.0) << "the border of the ground patch";
  EXPECT_EQ(double(page["strips"][0]["orange"]), 0.0);
  EXPECT_GT(double(page["strips"][2]["orange"]), 20000.0) << "the underside, seen from below";
  EXPECT_EQ(double(page["strips"][2]["red"]), 0.0) << "nothing is open any more";

  const Json index = seen(folder / "pages" / "index.html");
  ASSERT_FALSE(index.is_null());
  const auto sorted = index["sorted"].get<std::vector<double>>();
  EXPECT_EQ(sorted.size(), 3u);
  EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end()));
  EXPECT_EQ(index["thumbs"], 3);
  for (const std::string link : index["links"]) {
    EXPECT_TRUE(fs::exists(folder / "pages" / link)) << link;
  }
}

}  // namespace
}  // namespace clast
