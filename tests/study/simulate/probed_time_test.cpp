#include "study/simulate/detail/probed_time.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace clast::study_detail {
namespace {

TEST(ProbedTime, WithoutBlocksAtRestThePaceStays) {
  EXPECT_DOUBLE_EQ(estimate_remaining_time({1.0, 5.0, 40}, {3.0, 9.0, 40}, 10.0), 20.0);
}

TEST(ProbedTime, FollowsTheDecayOfTheNumberOfMovingBlocks) {
  // 400 exp(-t) blocks move, and each takes 0.01 s of computing per simulated second.
  const auto computed = [](double time) { return 4.0 * (1.0 - std::exp(-time)); };
  const ProbedState one = {0.0, 0.0, 400};
  const ProbedState two = {std::log(2.0), computed(std::log(2.0)), 200};
  EXPECT_NEAR(estimate_remaining_time(one, two, 60.0), 4.0 - two.computed, 1e-9);
  const double short_rest = std::log(2.0);
  EXPECT_NEAR(estimate_remaining_time(one, two, short_rest),
              computed(two.time + short_rest) - two.computed, 1e-9);
}

TEST(ProbedTime, NothingIsLeftIfAllBlocksRest) {
  EXPECT_EQ(estimate_remaining_time({1.0, 5.0, 40}, {3.0, 9.0, 0}, 10.0), 0.0);
}

}  // namespace
}  // namespace clast::study_detail
