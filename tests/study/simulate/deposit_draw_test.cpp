// Campaigns that draw their blocks from a scanned deposit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "library/deposit_observations.hpp"
#include "study/simulate/block_choice.hpp"
#include "tests/library/deposit_blocks.hpp"

namespace clast {
namespace {

constexpr std::size_t kDraws = 20000;

std::vector<CampaignBlock> drawn_from(const std::vector<Block>& blocks) {
  Campaign campaign;
  campaign.blocks.draw.emplace().count = kDraws;
  return sample_blocks(campaign, blocks);
}

TEST(DepositDraw, BlocksAreDrawnInTheNumbersForWhichTheyStand) {
  const std::vector<Block> blocks = deposit_of_sizes();
  const std::vector<double> weights = weigh_deposit(pointers_to(blocks))->weights;
  double sum = 0.0;
  for (const double weight : weights) sum += weight;
  std::vector<double> counts(blocks.size(), 0.0);
  for (const CampaignBlock& block : drawn_from(blocks)) counts[block.library] += 1.0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const double fraction = weights[i] / sum;
    const double deviation = std::sqrt(kDraws * fraction * (1.0 - fraction));
    EXPECT_NEAR(counts[i], kDraws * fraction, 4.5 * deviation) << blocks[i].id;
  }
}

TEST(DepositDraw, SizesVaryAsTheirIntervalsSay) {
  std::vector<double> scales;
  for (const CampaignBlock& block : drawn_from(deposit_of_sizes())) scales.push_back(block.scale);
  std::sort(scales.begin(), scales.end());
  EXPECT_NEAR(scales[kDraws / 20], 0.9, 0.003);
  EXPECT_NEAR(scales[kDraws / 2], std::sqrt(0.99), 0.003);
  EXPECT_NEAR(scales[kDraws * 19 / 20], 1.1, 0.003);
}

TEST(DepositDraw, BlocksOfOtherScansHaveEqualChancesAndTheirOwnSizes) {
  std::vector<Block> blocks = deposit_of_sizes();
  blocks[7].deposit.reset();
  std::vector<double> counts(blocks.size(), 0.0);
  for (const CampaignBlock& block : drawn_from(blocks)) {
    counts[block.library] += 1.0;
    EXPECT_EQ(block.scale, 1.0);
  }
  for (const double count : counts) EXPECT_NEAR(count, 1000.0, 4.5 * std::sqrt(950.0));
}

}  // namespace
}  // namespace clast
