#include "classify/long_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace clast {
namespace {

MeasuredBlock block_towards(double trend, double elongation = 2.0) {
  MeasuredBlock block = make_measured_block("B", {elongation, 1.0, 0.5});
  block.deposit.emplace();
  block.deposit->long_axis = {std::sin(trend), std::cos(trend), 0.0};
  return block;
}

TEST(LongAxes, OppositeEndsAreOneDirection) {
  std::vector<MeasuredBlock> blocks;
  for (int k = 0; k < 20; ++k) blocks.push_back(block_towards(0.5 + (k % 2 == 0 ? 0.0 : kPi)));
  const LongAxisTrends axes = summarise_long_axes(blocks);
  EXPECT_NEAR(axes.mean.direction, 0.5, 1e-12);
  EXPECT_NEAR(axes.mean.resultant_length, 1.0, 1e-12);
  EXPECT_LT(axes.p_value, 1e-6);
}

TEST(LongAxes, UniformTrendsAreNotSignificant) {
  Random random(3);
  int significant = 0;
  constexpr int kSamples = 400;
  for (int sample = 0; sample < kSamples; ++sample) {
    std::vector<MeasuredBlock> blocks;
    for (int k = 0; k < 30; ++k) blocks.push_back(block_towards(random.uniform(0.0, 2.0 * kPi)));
    significant += summarise_long_axes(blocks).p_value < 0.05;
  }
  EXPECT_NEAR(significant / static_cast<double>(kSamples), 0.05,
              4.0 * std::sqrt(0.05 * 0.95 / kSamples));
}

TEST(LongAxes, CompactBlocksAndTapedBlocksHaveNone) {
  const std::vector<MeasuredBlock> blocks = {block_towards(0.1),
                                             block_towards(0.1, 0.99 * kLeastElongation),
                                             make_measured_block("taped", {3.0, 1.0, 0.5})};
  EXPECT_EQ(summarise_long_axes(blocks).trends.size(), 1u);
  EXPECT_EQ(summarise_long_axes({}).p_value, 1.0);
}

}  // namespace
}  // namespace clast
