// Five hundred blocks falling into a pile.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

TEST(PileOf500, HasTheSameBitsOnTwoThreadsAndAccountsForItsEnergy) {
  const TerrainSurface terrain = ground(bowl());
  World alone = falling_pile(terrain, 500, 1, 1), together = falling_pile(terrain, 500, 1, 2);
  alone.run_until_rest(2.0);
  together.run_until_rest(2.0);
  const WorldStatistics statistics = alone.statistics();
  EXPECT_GT(statistics.touching_pairs, 500u);
  EXPECT_LT(alone.energy_balance().error, 0.005);
  EXPECT_EQ(alone.energy_balance().dissipated(), together.energy_balance().dissipated());
  constexpr double kMinSide = 0.4;  // m, about
  for (std::size_t i = 0; i < alone.body_count(); ++i) {
    EXPECT_EQ(alone.state(i).position, together.state(i).position);
    EXPECT_EQ(alone.state(i).orientation.coeffs(), together.state(i).orientation.coeffs());
    EXPECT_EQ(alone.state(i).velocity, together.state(i).velocity);
    const Vec3& position = alone.state(i).position;
    EXPECT_GT(position.z(), *terrain.height_at(position.x(), position.y(), position.z()));
  }
  // With e_n^2 = 0.01 a contact settles to F/(k_n e_n^2): 2 % of S under one block, and chains of
  // force carry some twenty of them on one patch. Deeper than that, but not through each other.
  EXPECT_LT(statistics.max_overlap, 0.5 * kMinSide);
  std::printf("largest overlap %.3f m\n", statistics.max_overlap);
}

}  // namespace
}  // namespace clast
