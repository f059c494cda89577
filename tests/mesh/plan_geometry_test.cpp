// Areas and insides of polygons in the plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "mesh/plan_geometry.hpp"

namespace clast {
namespace {

/// The sum of the angles that the sides take up, seen from the point: a turn inside, none outside.
bool is_wound_around(const std::vector<Vec2>& polygon, const Vec2& point) {
  double turn = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
    turn += std::atan2(cross(a, b), a.dot(b));
  }
  return std::abs(turn) > std::numbers::pi;
}

/// A star around (3, 2) with unequal rays, counter-clockwise.
std::vector<Vec2> star(Random& random) {
  std::vector<Vec2> corners;
  for (int i = 0; i < 11; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 11.0, ray = random.uniform(0.5, 3.0);
    corners.emplace_back(3.0 + ray * std::cos(angle), 2.0 + ray * std::sin(angle));
  }
  return corners;
}

TEST(PlanGeometry, AreasHaveTheSignOfTheirTurn) {
  EXPECT_EQ(twice_area({1, 1}, {3, 1}, {1, 2}), 2.0);
  EXPECT_EQ(twice_area({1, 1}, {1, 2}, {3, 1}), -2.0);
  const std::vector<Vec2> bracket = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  EXPECT_EQ(signed_area(bracket), 10.0);
  EXPECT_EQ(signed_area(std::vector<Vec2>(bracket.rbegin(), bracket.rend())), -10.0);
  std::vector<Vec2> closed = bracket;
  closed.push_back(closed.front());
  EXPECT_EQ(signed_area(closed), 10.0);
  EXPECT_EQ(signed_area(std::vector<Vec2>{{5, 5}, {7, 9}}), 0.0);
  EXPECT_EQ(signed_area({}), 0.0);
}

TEST(PlanGeometry, InsideIsWhatThePolygonWindsAround) {
  Random random(11);
  std::size_t inside = 0;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<Vec2> polygon = star(random);
    if (trial % 2 == 1) std::reverse(polygon.begin(), polygon.end());
    for (int i = 0; i < 100; ++i) {
      const Vec2 point(random.uniform(-1.0, 7.0), random.uniform(-2.0, 6.0));
      EXPECT_EQ(is_inside(polygon, point), is_wound_around(polygon, point)) << point.transpose();
      inside += is_inside(polygon, point);
    }
  }
  EXPECT_GT(inside, 300u);
}

// A square cut in two along its diagonal: each point of a lattice, also those on lines and corners,
// is in exactly one of the halves if it is in the square.
TEST(PlanGeometry, APointOnACommonSideIsInOneOfTwoPolygons) {
  const std::vector<Vec2> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const std::vector<Vec2> lower = {{0, 0}, {4, 0}, {4, 4}}, upper = {{0, 0}, {4, 4}, {0, 4}};
  for (int i = -1; i <= 9; ++i) {
    for (int j = -1; j <= 9; ++j) {
      const Vec2 point(0.5 * i, 0.5 * j);
      EXPECT_EQ(is_inside(lower, point) + is_inside(upper, point), is_inside(square, point) ? 1 : 0)
          << point.transpose();
    }
  }
}

}  // namespace
}  // namespace clast
