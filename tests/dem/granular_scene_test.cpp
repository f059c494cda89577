// Many blocks at once: small columns do what large ones do in experiments. The series with the
// published values is granular_series_test.
#include <gtest/gtest.h>

#include "tests/support/granular_column.hpp"

namespace clast {
namespace {

// What a wall holds goes on its way when the wall is removed: farther in units of its radius the
// higher it stood, but less than in proportion to its height. No column of 40 blocks reaches the
// law of fine grains, and none passes it.
TEST(GranularColumn, RunsOutFartherTheHigherItIs) {
  const Collapse low = collapse_column({.aspect = 0.7, .blocks = 40});
  const Collapse high = collapse_column({.aspect = 2.5, .blocks = 40});
  for (const Collapse& collapse : {low, high}) {
    std::printf("a %.2f runout %.3f\n", collapse.aspect(), collapse.runout());
    EXPECT_GE(collapse.continuous, 30u);
    EXPECT_LT(collapse.touching, 0.05);
    EXPECT_LT(collapse.energy_error, 1e-4);
    EXPECT_GT(collapse.runout(), 0.15);
    EXPECT_LT(collapse.runout(), published_runout(collapse.aspect()));
  }
  EXPECT_GT(high.runout(), 1.5 * low.runout());
}

}  // namespace
}  // namespace clast
