#include "samples/deposit/body_score.hpp"

#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TrueBlock visible_block(std::size_t number, double visible) {
  TrueBlock block;
  block.block = number;
  block.axes = {2.0, 1.0, 0.5};
  block.volume = 0.5;
  block.visible_fraction = visible;
  block.points = 1000;
  return block;
}

std::vector<StatedBody> read_text(const std::string& text) {
  const ScratchFolder folder;
  write_text_file(folder / "bodies.csv", text);
  return read_stated_bodies(folder / "bodies.csv");
}

TEST(StatedBodies, ColumnsAreFoundByName) {
  const std::vector<StatedBody> bodies =
      read_text("volume_m3_low90,block,I_m,L_m_low,L_m_high\n0.2,3,1.5,1,\n");
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_EQ(bodies[0].block, 3u);
  EXPECT_EQ(bodies[0].estimates[1].value, 1.5);
  EXPECT_EQ(bodies[0].estimates[0].low, 1.0);
  EXPECT_TRUE(std::isnan(bodies[0].estimates[0].high));
  EXPECT_TRUE(std::isnan(bodies[0].estimates[2].value));
  EXPECT_EQ(bodies[0].estimates[3].low90, 0.2);
}

TEST(StatedBodies, BadTablesAreRefused) {
  EXPECT_TRUE(contains(refusal([] { read_text("number,L_m\n1,2\n"); }), "no column \"block\""));
  EXPECT_TRUE(contains(refusal([] { read_text("block,L_m\n1,2\n1,3\n"); }), "block 1 twice"));
  EXPECT_TRUE(contains(refusal([] { read_text("block,L_m\n1,long\n"); }),
                       "row 1, column L_m: \"long\" is not a number"));
  EXPECT_TRUE(contains(refusal([] { read_text("block,L_m\n0,1\n"); }), "not a number from 1"));
}

// Two matched blocks, 40 and 60 % visible: S and volume of the first do not count in the total.
TEST(BodyScore, SidesOfBlocksThatAreHalfHiddenCountInTheirGroupAlone) {
  const std::vector<TrueBlock> blocks = {visible_block(1, 0.4), visible_block(2, 0.6)};
  const std::vector<std::uint32_t> truth = {1, 1, 2, 2}, proposed = {5, 5, 6, 6};
  const SegmentationScore segmentation = score_segmentation(truth, proposed, blocks);
  const std::vector<StatedBody> stated =
      read_text("block,L_m,S_m\n5,2.2,0.25\n6,2.2,0.55\n7,100,100\n");
  const std::vector<BodyScore> scores = score_bodies(segmentation, blocks, stated);
  ASSERT_EQ(scores.size(), 5u);
  EXPECT_EQ(scores[0].quantities[0].count, 2u);
  EXPECT_NEAR(scores[0].quantities[0].bias, 0.1, 1e-12);
  EXPECT_EQ(scores[0].quantities[2].count, 1u);
  EXPECT_NEAR(scores[0].quantities[2].bias, 0.1, 1e-12);
  EXPECT_EQ(scores[0].quantities[3].count, 0u);
  EXPECT_EQ(scores[1].quantities[0].count, 0u);  // up to 0.3
  EXPECT_EQ(scores[2].quantities[2].count, 1u);  // 0.3 to 0.5
  EXPECT_NEAR(scores[2].quantities[2].bias, -0.5, 1e-12);
  EXPECT_EQ(scores[3].quantities[2].count, 1u);  // 0.5 to 0.7
  EXPECT_EQ(scores[4].quantities[0].count, 0u);
}

}  // namespace
}  // namespace clast
