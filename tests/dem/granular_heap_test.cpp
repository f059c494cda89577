// Slopes of heaps of blocks against what is published of them (docs/accuracy.md, Heaps of
// blocks).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/granular_heap.hpp"

namespace clast {
namespace {

/// Largest overlap of any contact at rest, m: a tenth of d, which tips of elongated blocks reach
/// half of where they are wedged between others.
constexpr double kMaxOverlap = 0.1;

/// Mean slope of some heaps, degrees, with its standard error.
struct Slope {
  double mean = 0.0, error = 0.0;
};

Slope slope_of(HeapScene scene, const char* name) {
  constexpr std::uint64_t kHeaps = 3;
  double sum = 0.0, squares = 0.0;
  std::size_t blocks = 0;
  for (std::uint64_t seed = 1; seed <= kHeaps; ++seed) {
    scene.seed = seed;
    const Heap heap = heap_on_disc(scene);
    EXPECT_LT(heap.energy_error, 1e-4);
    EXPECT_LT(heap.touching, kMaxOverlap);
    EXPECT_GT(heap.blocks, 20u);
    blocks += heap.blocks;
    sum += heap.slope;
    squares += heap.slope * heap.slope;
  }
  const double n = kHeaps;
  const Slope slope{sum / n, std::sqrt((squares - sum * sum / n) / (n - 1.0) / n)};
  std::printf("%-10s mu %.1f: %.1f +- %.1f degrees, %zu blocks\n", name, scene.friction, slope.mean,
              slope.error, blocks / kHeaps);
  std::fflush(stdout);
  return slope;
}

void expect_same_slope(const Slope& a, const Slope& b) {
  EXPECT_NEAR(a.mean, b.mean, 3.0 * std::hypot(a.error, b.error));
}
void expect_steeper(const Slope& a, const Slope& b) {
  EXPECT_GT(a.mean - b.mean, 2.0 * std::hypot(a.error, b.error));
}

// Without rolling friction, so that shape and friction alone hold the slope.
TEST(GranularHeap, IsSteeperWithFrictionAndTheSameForOtherStepsAndStiffness) {
  const Slope balls_10 = slope_of({HeapShape::kBall, 0.1}, "balls");
  const Slope balls = slope_of({HeapShape::kBall, 0.5}, "balls");
  const Slope compact_10 = slope_of({HeapShape::kCompact, 0.1}, "compact");
  const Slope compact_30 = slope_of({HeapShape::kCompact, 0.3}, "compact");
  const Slope compact = slope_of({HeapShape::kCompact, 0.5}, "compact");
  const Slope compact_70 = slope_of({HeapShape::kCompact, 0.7}, "compact");
  expect_steeper(balls, balls_10);
  expect_steeper(compact_30, compact_10);
  EXPECT_GT(compact.mean, compact_30.mean);
  EXPECT_GT(compact_70.mean, compact_30.mean);
  std::printf("half the step: ");
  expect_same_slope(slope_of({HeapShape::kCompact, 0.5, 1, 0.5, 1.0}, "compact"), compact);
  std::printf("twice the stiffness: ");
  expect_same_slope(slope_of({HeapShape::kCompact, 0.5, 1, 1.0, 2.0}, "compact"), compact);
}

// On discs of 8 d: what elongation adds is less than the scatter of smaller heaps.
TEST(GranularHeap, IsSteeperForElongatedBlocks) {
  const auto on_wide_disc = [](HeapShape shape, const char* name) {
    return slope_of({.shape = shape, .radius = 8.0}, name);
  };
  const Slope balls = on_wide_disc(HeapShape::kBall, "balls");
  const Slope compact = on_wide_disc(HeapShape::kCompact, "compact");
  const Slope elongated = on_wide_disc(HeapShape::kElongated, "elongated");
  EXPECT_GT(compact.mean, balls.mean);
  expect_steeper(elongated, compact);
}

}  // namespace
}  // namespace clast
