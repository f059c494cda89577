#include "study/campaign/barrier_line.hpp"
#include "mesh/plan_geometry.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/random.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

std::string refused_line(const std::vector<Vec2>& line) {
  return refusal([&] { check_barrier_line(line); });
}

TEST(BarrierLine, OpenLinesAndRingsThatMeetNothingAreTaken) {
  EXPECT_EQ(refused_line({{0, 0}, {1, 0}}), "");
  EXPECT_EQ(refused_line({{0, 0}, {4, 0}, {4, 3}, {1, 3}, {1, 1}}), "");
  EXPECT_EQ(refused_line({{0, 0}, {4, 0}, {4, 3}, {0, 0}}), "");
  EXPECT_EQ(refused_line({{0, 0}, {1, 0}, {2, 0}, {3, 0}}), "") << "straight on is no way back";
  // A hair-pin whose legs are a centimetre apart, at coordinates of a map.
  const Vec2 map(900000.0, 6500000.0);
  EXPECT_EQ(refused_line({map, map + Vec2(50, 0), map + Vec2(50, 0.01), map + Vec2(0, 0.01)}), "");
}

TEST(BarrierLine, OneThatCrossesItselfIsRefusedWithSegmentsAndPlace) {
  const std::string eight = refused_line({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  EXPECT_TRUE(contains(eight, "segments 1 and 3 meet at (2, 2)")) << eight;
  // A pentagram: of its five crossings the first is named.
  const std::string star = refused_line({{0, 0}, {4, 3}, {-1, 3}, {3, 0}, {1.5, 5}, {0, 0}});
  EXPECT_TRUE(contains(star, "segments 1 and 3 meet at")) << star;
}

TEST(BarrierLine, OneThatTouchesOrRetracesItselfIsRefused) {
  EXPECT_TRUE(contains(refused_line({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 0}}),
                       "segments 1 and 4 meet at (2, 0)"));
  EXPECT_TRUE(contains(refused_line({{0, 0}, {4, 0}, {1, 0}}), "segments 1 and 2 meet at (1, 0)"));
  EXPECT_TRUE(contains(refused_line({{0, 0}, {4, 0}, {0, 0}}), "segments 1 and 2 meet at (0, 0)"));
  EXPECT_TRUE(contains(refused_line({{0, 0}, {4, 0}, {-2, 0}}), "segments 1 and 2 meet at (0, 0)"));
  // Back over an earlier segment.
  EXPECT_TRUE(contains(refused_line({{0, 0}, {4, 0}, {4, 1}, {5, 1}, {5, 0}, {3, 0}}),
                       "segments 1 and 5 meet"));
  // Once around and on: the ring does not end with its first return.
  EXPECT_TRUE(
      contains(refused_line({{0, 0}, {4, 0}, {4, 3}, {0, 0}, {-1, -2}}), "segments 1 and 3"));
  // A ring whose ends miss each other by less than anyone surveys.
  EXPECT_TRUE(contains(refused_line({{0, 0}, {4, 0}, {4, 3}, {1e-8, 0}}), "segments 1 and 3 meet"));
}

// Any pair of segments, whatever the order that the search goes in, against all pairs.
TEST(BarrierLine, ManySegmentsAreRefusedWhereTwoOfThemMeet) {
  Random random(11);
  std::size_t crossing = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Vec2> line;
    for (int i = 0; i < 6; ++i) line.emplace_back(random.uniform(0, 9), random.uniform(0, 9));
    bool meets = false;
    const auto side = [](const Vec2& a, const Vec2& b, const Vec2& p) {
      return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x()) > 0.0;
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      for (std::size_t k = i + 2; k + 1 < line.size(); ++k) {
        const Vec2 &a = line[i], &b = line[i + 1], &c = line[k], &d = line[k + 1];
        meets = meets || (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b));
      }
    }
    crossing += meets;
    EXPECT_EQ(!refused_line(line).empty(), meets) << trial;
  }
  EXPECT_GT(crossing, 50u);
  EXPECT_LT(crossing, 299u);
}

TEST(BarrierLine, InsideOfARingIsInsideWhicheverWayItRuns) {
  const std::vector<Vec2> ring = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}, {0, 0}};
  const std::vector<Vec2> turned(ring.rbegin(), ring.rend());
  EXPECT_TRUE(is_ring(ring));
  EXPECT_FALSE(is_ring(std::vector<Vec2>(ring.begin(), ring.end() - 1)));
  EXPECT_TRUE(is_counter_clockwise(ring));
  EXPECT_FALSE(is_counter_clockwise(turned));
  for (const auto& line : {ring, turned}) {
    EXPECT_TRUE(is_inside(line, {1, 1}) && is_inside(line, {3.9, 3.7}));
    EXPECT_FALSE(is_inside(line, {2, 2}) || is_inside(line, {5, 1}) || is_inside(line, {-1, 4}));
  }
}

}  // namespace
}  // namespace clast
