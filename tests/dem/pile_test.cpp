// Five hundred blocks falling into a pile.
#include <gtest/gtest.h>

#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

TEST(PileOf500, HasTheSameBitsOnTwoThreadsAndAccountsForItsEnergy) {
  const TerrainSurface terrain = ground(bowl());
  World alone = falling_pile(terrain, 500, 1, 1), together = falling_pile(terrain, 500, 1, 2);
  alone.run_until(2.0);
  together.run_until(2.0);
  const WorldStatistics statistics = alone.statistics();
  EXPECT_GT(statistics.touching_pairs, 500u);
  EXPECT_LT(alone.energy().error, 0.005);
  EXPECT_EQ(alone.energy().dissipated(), together.energy().dissipated());
  const double largest = 0.02 * 0.4;  // the depth that `auto` allows for S = 0.4 m
  for (std::size_t i = 0; i < alone.body_count(); ++i) {
    EXPECT_EQ(alone.state(i).position, together.state(i).position);
    EXPECT_EQ(alone.state(i).orientation.coeffs(), together.state(i).orientation.coeffs());
    EXPECT_EQ(alone.state(i).velocity, together.state(i).velocity);
    const Vec3& place = alone.state(i).position;
    EXPECT_GT(place.z(), *terrain.height(place.x(), place.y(), place.z()));
  }
  // The lowest carry the whole column on a few points: deeper than one block alone would lie, but
  // not through each other.
  EXPECT_LT(statistics.max_overlap, 15.0 * largest);
}

}  // namespace
}  // namespace clast
