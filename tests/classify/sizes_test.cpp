#include "classify/sizes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.hpp"

namespace clast {
namespace {

/// Cubes of these sizes.
std::vector<Axes> cubes(const std::vector<double>& sizes) {
  std::vector<Axes> blocks;
  for (const double d : sizes) blocks.push_back({d, d, d});
  return blocks;
}

TEST(Sizes, NominalDiameterIsTheCubeOfEqualBox) {
  EXPECT_NEAR(nominal_diameter({4.0, 2.0, 1.0}), 2.0, 1e-15);
}

TEST(Sizes, QuantilesByNumberAndByMass) {
  const auto blocks = cubes({1, 2, 3, 4, 5});
  const SizeDistribution bare = size_distribution(blocks);
  EXPECT_NEAR(bare.d10, 1.4, 1e-12);
  EXPECT_NEAR(bare.d50, 3.0, 1e-12);
  EXPECT_NEAR(bare.d90, 4.6, 1e-12);
  EXPECT_FALSE(bare.mass_d50.has_value());
  const std::vector<double> masses = {1, 8, 27, 64, 125};
  // Middles of the steps by mass: ..., 0.302 for 4 (68/225), 0.722 for 5 (162.5/225).
  const double expected = 4.0 + (0.5 - 68.0 / 225.0) / ((162.5 - 68.0) / 225.0);
  EXPECT_NEAR(*size_distribution(blocks, masses).mass_d50, expected, 1e-12);
}

// e^0, e^1, e^2: mean of ln d 1, variance 2/3.
TEST(Sizes, LogNormalFitInClosedForm) {
  const auto fit = size_distribution(cubes({1.0, std::exp(1.0), std::exp(2.0)})).log_normal;
  ASSERT_TRUE(fit.has_value());
  EXPECT_NEAR(fit->scale, std::exp(1.0), 1e-12);
  EXPECT_NEAR(fit->spread, std::sqrt(2.0 / 3.0), 1e-12);
  // At the smallest: 0.5 erfc(1 / (sigma sqrt 2)) against 1/3.
  EXPECT_NEAR(fit->distance, 1.0 / 3.0 - 0.5 * std::erfc(1.0 / std::sqrt(4.0 / 3.0)), 1e-12);
}

// Neither parameter can be moved without making the sizes less likely.
TEST(Sizes, RosinRammlerFitIsTheMostLikely) {
  Random random(2);
  for (const double n : {0.8, 1.5, 4.0}) {
    std::vector<double> sizes;
    for (int i = 0; i < 400; ++i) {
      sizes.push_back(0.6 * std::pow(-std::log(1.0 - random.uniform()), 1.0 / n));
    }
    const SizeFit fit = *size_distribution(cubes(sizes)).rosin_rammler;
    const auto likelihood = [&](double scale, double spread) {
      double sum = 0.0;
      for (const double d : sizes) {
        sum += std::log(spread / scale) + (spread - 1.0) * std::log(d / scale) -
               std::pow(d / scale, spread);
      }
      return sum;
    };
    const double best = likelihood(fit.scale, fit.spread);
    for (const double off : {0.999, 1.001}) {
      EXPECT_GT(best, likelihood(off * fit.scale, fit.spread));
      EXPECT_GT(best, likelihood(fit.scale, off * fit.spread));
    }
    EXPECT_NEAR(fit.scale / 0.6, 1.0, 0.15);
    EXPECT_NEAR(fit.spread / n, 1.0, 0.15);
    EXPECT_LT(fit.distance, 0.06);
  }
}

TEST(Sizes, EqualBlocksHaveNoFit) {
  const SizeDistribution equal = size_distribution(cubes({0.5, 0.5, 0.5}));
  EXPECT_NEAR(equal.d50, 0.5, 1e-15);
  EXPECT_FALSE(equal.log_normal || equal.rosin_rammler);
}

TEST(Sizes, SizeGoesWithShapeWhereItDoes) {
  std::vector<Axes> blocks;
  for (int i = 1; i <= 10; ++i) blocks.push_back({1.0 * i * (1.0 + 0.1 * i), 1.0 * i, 0.5 * i});
  const auto found = size_and_shape(blocks);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->s_c, 1.0, 1e-15);
  EXPECT_NEAR(found->s_l, -1.0, 1e-15);
  EXPECT_NEAR(found->disc_rod_index, 1.0, 1e-15);
  EXPECT_FALSE(size_and_shape(cubes({1, 2})).has_value());
  EXPECT_EQ(size_and_shape(cubes({1, 2, 3}))->disc_rod_index, 0.0);
}

}  // namespace
}  // namespace clast
