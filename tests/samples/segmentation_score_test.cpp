#include "samples/deposit/segmentation_score.hpp"

#include <gtest/gtest.h>

#include "tests/support/refusal.hpp"

namespace clast {
namespace {

using Labels = std::vector<std::uint32_t>;

TrueBlock true_block(std::size_t number, bool eligible) {
  TrueBlock block;
  block.block = number;
  block.visible_fraction = eligible ? 0.5 : 0.1;
  block.points = 1000;
  return block;
}

/// Labels with `counts[i]` points of truth and proposal `pairs[i]`.
struct Cloud {
  Labels truth, proposed;
  void add(std::size_t count, std::uint32_t true_number, std::uint32_t proposal) {
    truth.insert(truth.end(), count, true_number);
    proposed.insert(proposed.end(), count, proposal);
  }
};

TEST(SegmentationScore, TheTruthScoresOne) {
  Cloud cloud;
  cloud.add(5, 0, 0);
  cloud.add(10, 1, 7);
  cloud.add(20, 2, 3);
  const std::vector<TrueBlock> blocks = {true_block(1, true), true_block(2, true)};
  const SegmentationScore score = score_segmentation(cloud.truth, cloud.proposed, blocks);
  EXPECT_EQ(score.precision(), 1.0);
  EXPECT_EQ(score.recall(), 1.0);
  EXPECT_EQ(score.close_fraction(), 1.0);
  EXPECT_EQ(score.blocks[0].proposal, 7u);
  EXPECT_EQ(score.blocks[1].iou, 1.0);
  EXPECT_EQ(score.over_segmented, 0u);
  EXPECT_EQ(score.under_segmented, 0u);
}

TEST(SegmentationScore, CountsAreThoseDoneByHand) {
  Cloud cloud;
  // Block 1: 60 of 100 points in proposal 1, which has 20 of the ground: IoU 60 / 120, no match.
  cloud.add(60, 1, 1);
  cloud.add(40, 1, 0);
  cloud.add(20, 0, 1);
  // Block 2: halves of 51 and 49 points: IoU 0.51, a match, and the other half is false.
  cloud.add(51, 2, 2);
  cloud.add(49, 2, 3);
  // Blocks 3 and 4 in one proposal: IoU 100 / 160 and 60 / 160.
  cloud.add(100, 3, 4);
  cloud.add(60, 4, 4);
  // Proposal 5 lies on the ground, proposal 6 on block 5, which is not eligible.
  cloud.add(30, 0, 5);
  cloud.add(30, 5, 6);
  // Block 6 is a close match: IoU 90 / 100.
  cloud.add(90, 6, 8);
  cloud.add(10, 6, 0);
  std::vector<TrueBlock> blocks;
  for (std::size_t number = 1; number <= 6; ++number) {
    blocks.push_back(true_block(number, number != 5));
  }
  const SegmentationScore score = score_segmentation(cloud.truth, cloud.proposed, blocks);
  EXPECT_EQ(score.eligible, 5u);
  EXPECT_EQ(score.matched, 3u);  // 2, 3, 6
  EXPECT_EQ(score.close, 1u);
  EXPECT_EQ(score.proposals, 7u);
  EXPECT_EQ(score.false_proposals, 3u);  // 1, 3, 5
  EXPECT_EQ(score.on_ground, 1u);
  EXPECT_EQ(score.ignored_proposals, 1u);
  EXPECT_EQ(score.over_segmented, 1u);   // block 2
  EXPECT_EQ(score.under_segmented, 1u);  // proposal 4
  EXPECT_DOUBLE_EQ(score.precision(), 3.0 / 6.0);
  EXPECT_DOUBLE_EQ(score.recall(), 3.0 / 5.0);
  EXPECT_DOUBLE_EQ(score.close_fraction(), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(score.blocks[0].iou, 0.5);
  EXPECT_DOUBLE_EQ(score.blocks[2].iou, 100.0 / 160.0);
  EXPECT_EQ(score.blocks[3].proposal, 4u);
}

TEST(SegmentationScore, AMatchedBlockThatIsNotEligibleIsNeitherRightNorFalse) {
  Cloud cloud;
  cloud.add(10, 1, 1);
  cloud.add(10, 2, 2);
  const std::vector<TrueBlock> blocks = {true_block(1, true), true_block(2, false)};
  const SegmentationScore score = score_segmentation(cloud.truth, cloud.proposed, blocks);
  EXPECT_EQ(score.matched, 1u);
  EXPECT_EQ(score.ignored_proposals, 1u);
  EXPECT_EQ(score.precision(), 1.0);
}

TEST(SegmentationScore, NoProposalsScoreZero) {
  Cloud cloud;
  cloud.add(10, 1, 0);
  const SegmentationScore score =
      score_segmentation(cloud.truth, cloud.proposed, std::vector<TrueBlock>{true_block(1, true)});
  EXPECT_EQ(score.precision(), 0.0);
  EXPECT_EQ(score.recall(), 0.0);
  EXPECT_EQ(score.close_fraction(), 0.0);
}

TEST(SegmentationScore, ABlockIsEligibleAboveAQuarterOfItsSurfaceAnd400Points) {
  TrueBlock block = true_block(1, true);
  block.visible_fraction = 0.25;
  EXPECT_FALSE(block.is_eligible());
  block.visible_fraction = 0.251;
  block.points = 400;
  EXPECT_FALSE(block.is_eligible());
  block.points = 401;
  EXPECT_TRUE(block.is_eligible());
}

TEST(AlignLabels, PointsInAnotherOrderAndMissingOnesAreFound) {
  const LabelledCloud truth{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0, 1, 2}};
  const LabelledCloud labelled{{{2, 0, 1e-5}, {0, 0, 0}}, {9, 4}};
  EXPECT_EQ(align_labels(truth, labelled, 1e-4), (Labels{4, 0, 9}));
  EXPECT_EQ(align_labels(truth, truth, 1e-4), truth.blocks);
}

TEST(AlignLabels, ARepeatedPointIsRefused) {
  const LabelledCloud truth{{{0, 0, 0}, {1, 0, 0}}, {1, 2}};
  const LabelledCloud labelled{{{1, 0, 0}, {1, 0, 0}}, {1, 2}};
  EXPECT_TRUE(contains(refusal([&] { align_labels(truth, labelled, 1e-4); }),
                       "labelled point 2 at (1, 0, 0) repeats an earlier one"));
}

TEST(AlignLabels, AStrangePointIsRefused) {
  const LabelledCloud truth{{{0, 0, 0}}, {1}};
  const LabelledCloud labelled{{{0, 0, 0.01}}, {1}};
  EXPECT_TRUE(contains(refusal([&] { align_labels(truth, labelled, 1e-4); }),
                       "labelled point 1 at (0, 0, 0.01) is no point of the scan"));
}

}  // namespace
}  // namespace clast
