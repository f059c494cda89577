#include "report/scans/deposit_page.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "mesh/plan_geometry.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/markup.hpp"

namespace clast {
namespace {

/// Domes in a square grid on rough ground, seen from above.
class DomeField {
 public:
  DomeField(std::size_t blocks, std::size_t points) {
    const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(blocks)));
    const double width = static_cast<double>(side);
    Random random(7);
    scan.spacing = width / std::sqrt(points);
    for (std::size_t i = 0; i < points; ++i) {
      const Vec2 plan(random.uniform(0.0, width), random.uniform(0.0, width));
      const auto column = static_cast<std::size_t>(plan.x()),
                 row = static_cast<std::size_t>(plan.y());
      const double away = (plan - Vec2(column + 0.5, row + 0.5)).norm();
      const bool on_block = away < 0.4 && column * side + row < blocks;
      const double height = on_block ? std::sqrt(0.16 - away * away) : 0.0;
      scan.raw.vertices.push_back({plan.x(), plan.y(), height + 0.01 * random.normal()});
      scan.block_of_point.push_back(on_block ? static_cast<std::uint32_t>(column * side + row + 1)
                                             : 0);
    }
    for (std::size_t b = 0; b < blocks; ++b) {
      made.push_back(filled_block("talus_" + std::to_string(b + 1)));
      made.back().deposit = {.points = 900,
                             .spacing = scan.spacing,
                             .visible_fraction = 0.5,
                             .confidence = 0.5 + 0.4 * std::sin(static_cast<double>(b))};
    }
  }
  DepositPageContents contents() {
    DepositPageContents deposit{.name = "talus", .file = "scans/talus <1>.las", .scan = &scan};
    for (const Block& block : made) deposit.ids.push_back(block.id);
    deposit.blocks = &made;
    deposit.next_command = "clast reconstruct 'scans/talus <1>.las'";
    return deposit;
  }

  FieldScan scan;
  std::vector<Block> made;
};

TEST(DepositPageText, ListsBlocksByConfidenceAndPartsWithReasons) {
  DomeField field(4, 20000);
  field.made[2].deposit->confidence = 0.05;
  field.scan.left_out = {{LeftOutReason::kMostlyHidden, {1.25, 0.5, 0.75}, 321},
                         {LeftOutReason::kTooSmall, {0.5, 0.25, 0.125}, 99}};
  const std::string html = make_deposit_page(field.contents()).html;
  EXPECT_EQ(unbalanced(html), "");
  for (const char* outside : {"http:", "https:", "src=", "<link"}) {
    EXPECT_EQ(count_of(html, outside), 0u) << outside;
  }
  EXPECT_NE(html.find("4 blocks in 20000 points of scans/talus &lt;1&gt;.las, 2 parts left out"),
            std::string::npos);
  std::size_t last = 0;
  std::vector<std::pair<double, std::string>> order;
  for (const Block& block : field.made) order.emplace_back(block.deposit->confidence, block.id);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order.front().second, "talus_3");
  for (const auto& [confidence, id] : order) {
    const std::size_t at = html.find("href=\"blocks/" + id + ".html\"");
    ASSERT_NE(at, std::string::npos) << id;
    EXPECT_GT(at, last) << id;
    last = at;
  }
  EXPECT_EQ(count_of(html, name_of(LeftOutReason::kMostlyHidden)), 1u);
  EXPECT_EQ(count_of(html, "smaller than asked for"), 1u);
  EXPECT_EQ(count_of(html, "<td>321</td>"), 1u);
  EXPECT_EQ(count_of(html, "clast reconstruct &#39;scans/talus &lt;1&gt;.las&#39;") +
                count_of(html, "clast reconstruct 'scans/talus &lt;1&gt;.las'"),
            1u);
}

TEST(DepositPageText, OutlinesGoAroundThePointsOfEachBlock) {
  DomeField field(4, 20000);
  const DepositPage page = make_deposit_page(field.contents());
  ASSERT_EQ(page.map.blocks.size(), 4u);
  for (const report_detail::DepositMapBlock& block : page.map.blocks) {
    ASSERT_EQ(block.outlines.size(), 1u);
    EXPECT_NEAR(signed_area(block.outlines[0]), kPi * 0.16, 0.12 * kPi * 0.16);
    EXPECT_EQ(block.points, 900u);
  }
}

TEST(DepositPageText, TheReferenceSystemHoldsForUnchangedCoordinates) {
  DomeField field(1, 5000);
  field.scan.crs = "EPSG:2154";
  DepositPageContents deposit = field.contents();
  EXPECT_EQ(make_deposit_page(deposit).map.crs, "EPSG:2154");
  deposit.unit = 0.001;
  field.scan.spacing *= 0.001;
  EXPECT_EQ(make_deposit_page(deposit).map.crs, "");
}

TEST(DepositPageText, OfAMillionPointsAndManyBlocksIsOfAFewMegabytes) {
  DomeField field(300, 1'000'000);
  const std::string html = make_deposit_page(field.contents()).html;
  EXPECT_LT(html.size(), 5'000'000u);
  RecordProperty("bytes", static_cast<int>(html.size()));
}

}  // namespace
}  // namespace clast
