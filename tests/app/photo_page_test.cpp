/// clast reconstruct --report and --json on photographs: the rendered rock with a board, and a real
/// boulder without any scale.
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/app/browser.hpp"
#include "tests/app/scan_page_probe.hpp"
#include "tests/reconstruct/photos/synthetic_rock.hpp"
#include "tests/support/markup.hpp"

namespace clast {
namespace {

using Json = nlohmann::json;

class PhotoPage : public testing::Test {
 protected:
  void SetUp() override { expect_browser(); }
  /// The block in JSON, with its page in pages/.
  Json made(const std::string& set, const std::vector<std::string>& more) {
    const std::string photos = test_data("photos/" + set).string();
    // The hull of a block shows as much of its photos as the block, and is fitted sooner.
    std::vector<std::string> arguments = {"reconstruct", photos + "/images",
                                          "--model",     photos + "/colmap_txt",
                                          "--convex",    "--vertices",
                                          "100",         "--report",
                                          "pages",       "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = run_clast(arguments, folder.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.exit_code == 0 ? Json::parse(run.out)["blocks"][0] : Json();
  }
  ScratchFolder folder;
};

/// Markers 0 to 3 of the rendered set where they truly are, but for one moved by `error`, m.
std::string board_of_rock(int moved, double error) {
  std::string text = "dictionary = \"4x4_50\"\nmarker_side_m = 0.2\n";
  for (auto [id, centre] : true_marker_centres()) {
    if (id == moved) centre.x() += error;
    text += "[[marker]]\nid = " + std::to_string(id) + "\ncentre_m = [" +
            std::to_string(centre.x()) + ", " + std::to_string(centre.y()) + ", " +
            std::to_string(centre.z()) + "]\n";
  }
  return text;
}

// True scale: 0.378577 m per unit of the stored model, by the set's README.
TEST_F(PhotoPage, TheRockHasItsRingItsCoverageAndTheScaleOfItsBoard) {
  write_text_file(folder / "board.toml", board_of_rock(2, 0.03));
  const Json block = made("synthetic_rock", {"--board", "board.toml"});
  ASSERT_FALSE(block.is_null());
  const Json& photos = block["photos"];
  EXPECT_EQ(photos["with_camera"], 36);
  EXPECT_TRUE(photos["without_camera"].empty());
  EXPECT_EQ(photos["ring"]["cameras"].size(), 36u);
  EXPECT_TRUE(photos["ring"]["gaps"].empty());
  EXPECT_GT(double(photos["coverage"][0]["photos_share"]), 0.75) << "all but the underside";
  EXPECT_LT(double(photos["coverage"][0]["photos_share"]), 0.98);
  ASSERT_EQ(photos["markers"].size(), 4u);
  EXPECT_FALSE(photos["markers"][2]["used"]);
  EXPECT_TRUE(photos["markers"][1]["used"]);
  EXPECT_EQ(photos["scale"]["source"], "board");
  EXPECT_EQ(photos["scale"]["lengths"].size(), 3u);
  EXPECT_NEAR(double(photos["scale"]["metres_per_unit"]) / 0.378577, 1.0, 0.0005);
  EXPECT_GT(double(block["mass_kg"]), 300.0);
  EXPECT_TRUE(contains(block["warnings"].dump(), "scale by board: 3 of 3 lengths agree, to 0.00"));

  const fs::path page = folder / "pages" / "blocks" / "synthetic_rock.html";
  const std::string html = read_text_file(page);
  EXPECT_EQ(unbalanced(html), "");
  expect_self_contained(html);
  EXPECT_EQ(count_of(html, "<h2>Photographs</h2>"), 1u);
  EXPECT_EQ(count_of(html, "left out: its position differs from that on the board"), 1u);
  EXPECT_EQ(count_of(html, "class=\"seat"), 36u);
  const Json shown = probed(page, kScanPageProbe, folder);
  ASSERT_FALSE(shown.is_null()) << "the page can't be drawn";
}

TEST_F(PhotoPage, ABoulderWithoutAScaleHasNoMassAnywhere) {
  const Json block = made("nlesc_rock", {"--allow-unscaled"});
  ASSERT_FALSE(block.is_null());
  EXPECT_TRUE(block["mass_kg"].is_null());
  EXPECT_TRUE(block.contains("box_units"));
  EXPECT_TRUE(contains(std::string(block["unscaled"]), "no scale"));
  EXPECT_EQ(block["photos"]["scale"]["source"], "none");
  EXPECT_EQ(block["photos"]["with_camera"], 47);
  for (const auto& warning : block["warnings"]) {
    EXPECT_FALSE(contains(std::string(warning), " kg")) << warning;
  }
  const std::string html = read_text_file(folder / "pages" / "blocks" / "nlesc_rock.html");
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_EQ(count_of(html, "none: unscaled"), 1u);
  EXPECT_FALSE(std::regex_search(html, std::regex("[0-9] kg|[0-9] (m|cm|mm)<")));
  EXPECT_TRUE(contains(read_text_file(folder / "pages" / "summary.csv"), ",none,"));
  const ProgramRun shown = run_clast({"show", "blocks.h5"}, folder.path());
  EXPECT_TRUE(contains(shown.out, "Unscaled")) << shown.out;
}

}  // namespace
}  // namespace clast
