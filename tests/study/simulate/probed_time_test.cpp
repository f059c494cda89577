#include "study/simulate/detail/probed_time.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace clast::study_detail {
namespace {

// Each moving block takes 0.01 s of computing per simulated second.
constexpr double kCost = 0.01;

TEST(ProbedTime, WithAMotionToTheTimeLimitThePaceStays) {
  const std::vector<MotionInterval> limit = {{0.0, 13.0}};
  EXPECT_DOUBLE_EQ(estimate_remaining_time({1.0, 5.0, 1}, {3.0, 9.0, 1}, 0.0, 1, limit), 20.0);
}

TEST(ProbedTime, BlocksThatMoveAsLongAsSingleOnesTakeTheIntegralOfTheirNumber) {
  // 400 blocks, whose motions end evenly from 0 to 40 s: (400 - 10 t) move.
  std::vector<MotionInterval> single;
  for (int i = 0; i < 400; ++i) single.push_back({0.0, 0.1 * (i + 0.5)});
  const auto computed = [](double t) { return kCost * (400.0 * t - 5.0 * t * t); };
  const ProbedState one = {10.0, computed(10.0), 300, 100}, two = {20.0, computed(20.0), 200, 200};
  EXPECT_NEAR(estimate_remaining_time(one, two, 0.0, 400, single), computed(40.0) - two.computed,
              1e-3 * two.computed);
  // The first blocks settled for 7 s before their release.
  const ProbedState later_one = {17.0, one.computed, 300, 100},
                    later_two = {27.0, two.computed, 200, 200};
  EXPECT_NEAR(estimate_remaining_time(later_one, later_two, 7.0, 400, single),
              computed(40.0) - two.computed, 1e-3 * two.computed);
}

TEST(ProbedTime, BlocksThatStopLaterThanSingleOnesContinueWithADelay) {
  const std::vector<MotionInterval> single = {{0.0, 2.0}, {0.0, 4.0}, {0.0, 6.0}, {0.0, 12.0}};
  // All 40 still move at 5 s, as single ones do until 2 s: 10 move for 0, 2, 4 and 10 s more.
  EXPECT_NEAR(estimate_remaining_time({3.0, 0.8, 40}, {5.0, 1.6, 40}, 0.0, 40, single), 1.6, 1e-12);
  // Half move at 5 s, as single ones do from 4 to 6 s: 10 for 1 and 7 s more.
  EXPECT_NEAR(estimate_remaining_time({3.0, 0.8, 20, 20}, {5.0, 1.2, 20, 20}, 0.0, 40, single), 0.8,
              1e-12);
}

TEST(ProbedTime, BlocksThatAreReleasedLaterCountFromTheirRelease) {
  const std::vector<MotionInterval> single = {{0.0, 6.0}, {20.0, 25.0}};
  // 10 of 20 are held until 20 s; the others move for 3 s more.
  EXPECT_NEAR(estimate_remaining_time({1.0, 0.1, 10}, {3.0, 0.3, 10}, 0.0, 20, single),
              kCost * (10 * 3.0 + 10 * 5.0), 1e-12);
}

TEST(ProbedTime, NothingIsLeftIfAllBlocksRest) {
  const std::vector<MotionInterval> single = {{0.0, 10.0}};
  EXPECT_EQ(estimate_remaining_time({1.0, 5.0, 40}, {3.0, 9.0, 0, 40}, 0.0, 40, single), 0.0);
}

}  // namespace
}  // namespace clast::study_detail
