#include "classify/size_draws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace clast {
namespace {

/// A block whose intervals extend by factors below and above each size.
MeasuredBlock block_with_intervals(const Axes& axes, double below, double above) {
  MeasuredBlock block = make_measured_block("B", axes);
  DepositObservation seen;
  seen.lower_axes = {axes.L * below, axes.I * below, axes.S * below};
  seen.upper_axes = {axes.L * above, axes.I * above, axes.S * above};
  seen.volume = 0.5 * axes.L * axes.I * axes.S;
  seen.lower_volume = 0.7 * seen.volume;
  seen.upper_volume = 1.6 * seen.volume;
  block.deposit = seen;
  return block;
}

TEST(SizeDraws, NineOfTenAreInsideTheIntervals) {
  const MeasuredBlock block = block_with_intervals({3.0, 1.0, 0.3}, 0.8, 1.1);
  Random random(1);
  constexpr int kDraws = 20000;
  int below = 0, above = 0, smaller = 0, larger = 0;
  for (int k = 0; k < kDraws; ++k) {
    const BlockSizes sizes = draw_block_sizes(block, random);
    below += sizes.axes.I < 0.8;
    above += sizes.axes.I > 1.1;
    smaller += sizes.volume < block.deposit->lower_volume;
    larger += sizes.volume > block.deposit->upper_volume;
  }
  // Five standard errors of a proportion of 5 %.
  for (const int count : {below, above, smaller, larger}) {
    EXPECT_NEAR(count / static_cast<double>(kDraws), 0.05, 5.0 * std::sqrt(0.05 * 0.95 / kDraws));
  }
}

TEST(SizeDraws, MediansAreTheGeometricMeansOfTheLimits) {
  const MeasuredBlock block = block_with_intervals({3.0, 1.0, 0.3}, 0.8, 1.1);
  const BlockSizes sizes = median_block_sizes(block);
  EXPECT_NEAR(sizes.axes.L, 3.0 * std::sqrt(0.88), 1e-12);
  EXPECT_NEAR(sizes.axes.S, 0.3 * std::sqrt(0.88), 1e-12);
  EXPECT_NEAR(sizes.volume, block.deposit->volume * std::sqrt(0.7 * 1.6), 1e-12);
}

TEST(SizeDraws, AxesKeepTheirOrderThoughTheIntervalsOverlap) {
  const MeasuredBlock block = block_with_intervals({1.02, 1.0, 0.99}, 0.7, 1.4);
  Random random(2);
  for (int k = 0; k < 1000; ++k) {
    const Axes axes = draw_block_sizes(block, random).axes;
    EXPECT_GE(axes.L, axes.I);
    EXPECT_GE(axes.I, axes.S);
    EXPECT_GT(axes.S, 0.0);
  }
}

TEST(SizeDraws, ErrorsOfTheAxesAreCorrelated) {
  const MeasuredBlock block = block_with_intervals({3.0, 1.0, 0.3}, 0.8, 1.25);
  Random random(3);
  constexpr int kDraws = 20000;
  double product = 0.0, first = 0.0, second = 0.0;
  for (int k = 0; k < kDraws; ++k) {
    const Axes axes = draw_block_sizes(block, random).axes;
    const double l = std::log(axes.L / 3.0), i = std::log(axes.I);
    product += l * i;
    first += l * l;
    second += i * i;
  }
  EXPECT_NEAR(product / std::sqrt(first * second), kAxisErrorCorrelation, 0.03);
}

TEST(SizeDraws, IntervalsWithoutWidthGiveTheEstimate) {
  const MeasuredBlock block = block_with_intervals({2.0, 1.0, 0.5}, 1.0, 1.0);
  Random random(4);
  const Axes axes = draw_block_sizes(block, random).axes;
  EXPECT_DOUBLE_EQ(axes.L, 2.0);
  EXPECT_DOUBLE_EQ(axes.I, 1.0);
  EXPECT_DOUBLE_EQ(axes.S, 0.5);
}

}  // namespace
}  // namespace clast
