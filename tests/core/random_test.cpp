#include "core/random.hpp"

#include <gtest/gtest.h>

namespace clast {
namespace {

// Reference outputs of SplitMix64 for seed 1234567, from its authors' program.
TEST(Random, MatchesThePublishedSequence) {
  Random random(1234567);
  EXPECT_EQ(random.next_bits(), 6457827717110365317ULL);
  EXPECT_EQ(random.next_bits(), 3203168211198807973ULL);
  EXPECT_EQ(random.next_bits(), 9817491932198370423ULL);
}

TEST(Random, MomentsOfTheDistributions) {
  Random random(7);
  const int count = 100000;
  double mean = 0.0, variance = 0.0, uniform_mean = 0.0;
  Mat3 rotated = Mat3::Zero();
  Vec3 direction = Vec3::Zero();
  for (int i = 0; i < count; ++i) {
    const double value = random.normal();
    mean += value / count;
    variance += value * value / count;
    uniform_mean += random.uniform() / count;
    rotated += random.rotation().toRotationMatrix() / count;
    direction += random.unit_vector() / count;
  }
  // Five standard errors.
  EXPECT_NEAR(mean, 0.0, 5.0 / std::sqrt(count));
  EXPECT_NEAR(variance, 1.0, 5.0 * std::sqrt(2.0 / count));
  EXPECT_NEAR(uniform_mean, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / count));
  EXPECT_LT(rotated.cwiseAbs().maxCoeff(), 5.0 * std::sqrt(1.0 / 3.0 / count));
  EXPECT_LT(direction.cwiseAbs().maxCoeff(), 5.0 * std::sqrt(1.0 / 3.0 / count));
}

TEST(Random, RotationsAreUnit) {
  Random random(3);
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(random.rotation().norm(), 1.0, 1e-15);
}

}  // namespace
}  // namespace clast
