#include "study/campaign/barrier.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "tests/support/gravity.hpp"

namespace clast {
namespace {

// A square of 200 m, of height slope x.
TerrainSurface plane(double slope) {
  TriangleMesh mesh;
  for (const Vec2& corner : {Vec2(-100, -100), Vec2(100, -100), Vec2(100, 100), Vec2(-100, 100)}) {
    mesh.vertices.emplace_back(corner.x(), corner.y(), slope * corner.x());
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return TerrainSurface(mesh, {0, 0});
}

// A cube of core side 1 m and radius 0.1 m, 1000 kg.
RigidBody cube() {
  RigidBody body;
  for (int i = 0; i < 8; ++i) {
    body.shape.vertices.emplace_back(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
  }
  body.shape.radius = 0.1;
  body.mass = 1000.0;
  body.moments = Vec3(200.0, 220.0, 240.0);
  body.smallest_side = 1.2;
  return body;
}

// A flight from (0, 0, 10) at (3, 1, 2) m/s for one second.
MotionStep flight(const RigidBody& body) {
  MotionStep step;
  step.begin_time = 4.0;
  step.end_time = 5.0;
  step.begin.position = Vec3(0, 0, 10);
  step.begin.velocity = Vec3(3, 1, 2);
  step.begin.angular_velocity = Vec3(0, 0, 1.5);
  step.end = free_flight(body, step.begin, 1.0, kTestGravity);
  step.flight = true;
  return step;
}

// Left of a line that runs to +y is -x: motion to +x is forward.
const Barrier kAcross{"across", {{1.2, -5}, {1.2, 5}}};

/// The only crossing, if there is one.
std::optional<Crossing> find_crossing(const Barrier& barrier, const RigidBody& body,
                                      const MotionStep& step, const TerrainSurface& terrain,
                                      double gravity) {
  const std::vector<Crossing> found = find_crossings(barrier, body, step, terrain, gravity);
  EXPECT_LE(found.size(), 1u);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

TEST(Barrier, FlightIsCrossedWhereTheParabolaSays) {
  const RigidBody body = cube();
  const auto crossing = find_crossing(kAcross, body, flight(body), plane(0.0), kTestGravity);
  ASSERT_TRUE(crossing);
  const double t = 1.2 / 3.0;
  EXPECT_TRUE(crossing->forward);
  EXPECT_NEAR(crossing->time, 4.0 + t, 1e-14);
  const Vec3 position(1.2, t, 10 + 2 * t - 0.5 * kTestGravity * t * t);
  const Vec3 velocity(3, 1, 2 - kTestGravity * t);
  EXPECT_LT((crossing->position - position).norm(), 1e-13);
  EXPECT_LT((crossing->velocity - velocity).norm(), 1e-13);
  EXPECT_LT((crossing->angular_velocity - Vec3(0, 0, 1.5)).norm(), 1e-9);
  EXPECT_NEAR(crossing->height, position.z(), 1e-12);
  EXPECT_NEAR(crossing->clearance, position.z() - 0.6, 1e-12);
  EXPECT_NEAR(crossing->translational_energy, 500.0 * velocity.squaredNorm(), 1e-9);
  EXPECT_NEAR(crossing->rotational_energy, 0.5 * 240.0 * 1.5 * 1.5, 1e-9);
}

TEST(Barrier, TurnedBarrierIsCrossedBackward) {
  const RigidBody body = cube();
  const Barrier turned{"turned", {kAcross.vertices[1], kAcross.vertices[0]}};
  const auto crossing = find_crossing(turned, body, flight(body), plane(0.0), kTestGravity);
  ASSERT_TRUE(crossing);
  EXPECT_FALSE(crossing->forward);
  EXPECT_NEAR(crossing->time, 4.4, 1e-14);
}

TEST(Barrier, PassingBesideTheSegmentIsNoCrossing) {
  const RigidBody body = cube();
  // The parabola passes x = 1.2 at y = 0.4.
  const MotionStep step = flight(body);
  const TerrainSurface ground = plane(0.0);
  EXPECT_TRUE(
      find_crossing({"holds it", {{1.2, 0.39}, {1.2, 5}}}, body, step, ground, kTestGravity));
  EXPECT_FALSE(
      find_crossing({"beyond", {{1.2, 0.41}, {1.2, 5}}}, body, step, ground, kTestGravity));
  EXPECT_FALSE(
      find_crossing({"before", {{1.2, -5}, {1.2, 0.39}}}, body, step, ground, kTestGravity));
  EXPECT_FALSE(
      find_crossing({"not reached", {{3.1, -5}, {3.1, 5}}}, body, step, ground, kTestGravity));
}

TEST(Barrier, ContactStepIsCrossedToANanosecond) {
  const RigidBody body = cube();
  // Braked along x: x = 3 t - t^2 passes 1.2 at t = (3 - sqrt(9 - 4.8))/2.
  MotionStep step;
  step.begin_time = 50.0;
  step.end_time = 51.0;
  step.begin.position = Vec3(0, 0, 0.6);
  step.begin.velocity = Vec3(3, 0, 0);
  step.end.position = Vec3(2, 0, 0.6);
  step.end.velocity = Vec3(1, 0, 0);
  const auto crossing = find_crossing(kAcross, body, step, plane(0.0), kTestGravity);
  ASSERT_TRUE(crossing);
  const double t = (3.0 - std::sqrt(9.0 - 4.8)) / 2.0;
  EXPECT_NEAR(crossing->time, 50.0 + t, 1.1e-9);
  EXPECT_NEAR(crossing->position.x(), 1.2, 3e-9);
  EXPECT_NEAR(crossing->velocity.x(), 3.0 - 2.0 * t, 1e-8);
  EXPECT_NEAR(crossing->clearance, 0.0, 1e-12);
}

TEST(Barrier, StepsThatMeetOnThePlaneCrossItOnce) {
  const RigidBody body = cube();
  const TerrainSurface ground = plane(0.0);
  MotionStep first;
  first.end_time = 1.0;
  first.begin.position = Vec3(0.2, 0, 2);
  first.end.position = Vec3(1.2, 0, 2);
  first.begin.velocity = first.end.velocity = Vec3(1, 0, 0);
  MotionStep second = first;
  second.begin_time = 1.0;
  second.end_time = 2.0;
  second.begin = first.end;
  second.end.position = Vec3(2.2, 0, 2);
  const auto at_end = find_crossing(kAcross, body, first, ground, kTestGravity);
  const auto at_begin = find_crossing(kAcross, body, second, ground, kTestGravity);
  EXPECT_TRUE(at_end);
  EXPECT_FALSE(at_begin);
}

TEST(Barrier, HeightAndClearanceAreVerticalToTheGroundUnderEach) {
  RigidBody body = cube();
  const MotionStep level = flight(body);
  MotionStep step = level;
  // An eighth of a turn about y brings an edge down: lowest core points under the centre.
  step.begin.orientation = Quat(Eigen::AngleAxisd(kPi / 4.0, Vec3::UnitY()));
  step.begin.angular_velocity.setZero();
  const auto crossing = find_crossing(kAcross, body, step, plane(0.5), kTestGravity);
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->height, crossing->position.z() - 0.6, 1e-12);
  EXPECT_NEAR(crossing->clearance, crossing->height - std::sqrt(0.5) - 0.1, 1e-9);

  // Half of that turn: the lowest edge lies off the centre by d, where the ground is d/2 lower.
  step.begin.orientation = Quat(Eigen::AngleAxisd(kPi / 8.0, Vec3::UnitY()));
  const auto tilted = find_crossing(kAcross, body, step, plane(0.5), kTestGravity);
  ASSERT_TRUE(tilted);
  const double half_diagonal = std::sqrt(0.5), angle = kPi / 4.0 - kPi / 8.0;
  // Turning about +y moves the lower edge at x = +0.5 down; it is ahead of the centre.
  const double ahead = half_diagonal * std::sin(angle), under = half_diagonal * std::cos(angle);
  EXPECT_NEAR(tilted->clearance, tilted->height - under - 0.1 - 0.5 * ahead, 1e-9);
}

TEST(Barrier, BesideTheSurveyedGroundNothingIsCounted) {
  const RigidBody body = cube();
  MotionStep step = flight(body);
  step.begin.position.x() = 99.0;
  step.end = free_flight(body, step.begin, 1.0, kTestGravity);
  const Barrier outside{"outside", {{101, -5}, {101, 5}}};
  EXPECT_FALSE(find_crossing(outside, body, step, plane(0.0), kTestGravity));
}

// From (0, 0) to (3, 1) m in a second, in plan a straight line: y = x / 3.
TEST(PolylineBarrier, EverySegmentThatTheFlightPassesIsCrossedInOrder) {
  const RigidBody body = cube();
  const Vec2 apex(2.5, 0.0);
  // It starts inside and leaves over the upper side.
  const Barrier wedge{"wedge", {{1.0, -5.0}, apex, {1.0, 5.0}}};
  const auto found = find_crossings(wedge, body, flight(body), plane(0.0), kTestGravity);
  ASSERT_EQ(found.size(), 1u);
  // y = x / 3 meets the second side, x = 2.5 - 0.3 y, at x = 2.5 / 1.1.
  EXPECT_NEAR(found[0].position.x(), 2.5 / 1.1, 1e-12);
  EXPECT_NEAR(found[0].time, 4.0 + 2.5 / 1.1 / 3.0, 1e-12);
  EXPECT_TRUE(found[0].forward);

  // A hook that the flight enters at x = 1 and leaves at x = 2.
  const Barrier hook{"hook", {{2.0, 5.0}, {2.0, -5.0}, {1.0, -5.0}, {1.0, 5.0}}};
  const auto both = find_crossings(hook, body, flight(body), plane(0.0), kTestGravity);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_NEAR(both[0].time, 4.0 + 1.0 / 3.0, 1e-14);
  EXPECT_NEAR(both[1].time, 4.0 + 2.0 / 3.0, 1e-14);
  EXPECT_TRUE(both[0].forward) << "this side runs to +y, so its left is -x";
  EXPECT_FALSE(both[1].forward) << "this one runs to -y";
}

TEST(PolylineBarrier, AnInnerPointIsCrossedOnce) {
  const RigidBody body = cube();
  // At x = 1 the flight is at y = 0.25; halves and quarters lose no digit.
  MotionStep step = flight(body);
  step.begin.velocity = Vec3(2.0, 0.5, 2.0);
  step.end = free_flight(body, step.begin, 1.0, kTestGravity);
  const Barrier bent{"bent", {{1.0, -5.0}, {1.0, 0.25}, {1.0, 5.0}}};
  const auto found = find_crossings(bent, body, step, plane(0.0), kTestGravity);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].time, 4.5);
  const Barrier ends_here{"ends here", {{1.0, -5.0}, {1.0, 0.25}}};
  EXPECT_EQ(find_crossings(ends_here, body, step, plane(0.0), kTestGravity).size(), 1u);
}

TEST(PolylineBarrier, StraightPiecesAreTheStraightBarrier) {
  const RigidBody body = cube();
  const auto whole = find_crossings(kAcross, body, flight(body), plane(0.0), kTestGravity);
  const Barrier pieces{"pieces", {{1.2, -5}, {1.2, 0.1}, {1.2, 0.7}, {1.2, 5}}};
  const auto cut = find_crossings(pieces, body, flight(body), plane(0.0), kTestGravity);
  ASSERT_EQ(whole.size(), 1u);
  ASSERT_EQ(cut.size(), 1u);
  EXPECT_EQ(cut[0].position, whole[0].position);
  EXPECT_EQ(cut[0].time, whole[0].time);
}

// A ring is entered and left, whichever way its points run.
class RingBarrier : public testing::TestWithParam<bool> {
 protected:
  /// A square of 2 m around (3, 0).
  Barrier square() const {
    Barrier barrier{"square", {{2, -1}, {4, -1}, {4, 1}, {2, 1}, {2, -1}}};
    if (!GetParam()) std::reverse(barrier.vertices.begin(), barrier.vertices.end());
    return barrier;
  }
  /// 'i' and 'o' for the entries and exits of a path of straight steps of a second each.
  std::string passed(const Barrier& barrier, const std::vector<Vec2>& path) const {
    const RigidBody body = cube();
    const TerrainSurface ground = plane(0.0);
    std::string ways;
    double last = 0.0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      MotionStep step;
      step.begin_time = static_cast<double>(i);
      step.end_time = step.begin_time + 1.0;
      step.begin.position << path[i], 2.0;
      step.end.position << path[i + 1], 2.0;
      step.begin.velocity << path[i + 1] - path[i], 0.0;
      step.end.velocity = step.begin.velocity;
      for (const Crossing& crossing : find_crossings(barrier, body, step, ground, kTestGravity)) {
        EXPECT_GE(crossing.time, last);
        last = crossing.time;
        // Left to right is out of a ring that runs counter-clockwise.
        ways += crossing.forward == GetParam() ? 'o' : 'i';
      }
    }
    return ways;
  }
};

TEST_P(RingBarrier, CountsWhatEntersAndLeaves) {
  EXPECT_EQ(passed(square(), {{0, 0}, {6, 0}}), "io") << "in one step";
  EXPECT_EQ(passed(square(), {{0, 0}, {3, 0.5}, {6, 0}}), "io");
  EXPECT_EQ(passed(square(), {{0, 0}, {3, 0.5}}), "i") << "comes to rest in it";
  EXPECT_EQ(passed(square(), {{3, 0}, {3.5, 0.1}, {6, 0}}), "o") << "starts in it";
  EXPECT_EQ(passed(square(), {{3, 0}, {3.5, 0.1}}), "") << "stays in it";
  EXPECT_EQ(passed(square(), {{0, 3}, {6, 3}}), "") << "passes beside it, over its sides' lines";
  EXPECT_EQ(passed(square(), {{0, 0}, {6, 0}, {6, 0.5}, {0, 0.5}}), "ioio") << "passes twice";
}

TEST_P(RingBarrier, TimesAndPlacesAreThoseOfTheSides) {
  const RigidBody body = cube();
  Barrier ring = square();
  // From (1.5, -2) to (3.5, 2), entered at x = 1.5 by y = x / 3.
  for (Vec2& point : ring.vertices) point = {point.x() - 0.5, 2.0 * point.y()};
  const auto found = find_crossings(ring, body, flight(body), plane(0.0), kTestGravity);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].time, 4.5, 1e-14);
  EXPECT_NEAR(found[0].position.y(), 0.5, 1e-14);
  EXPECT_EQ(found[0].forward, !GetParam());
}

// Corners hit exactly and sides run along are where a count by sides alone errs.
TEST_P(RingBarrier, EntriesAndExitsAlternateOverCornersAndAlongSides) {
  EXPECT_EQ(passed(square(), {{1, -2}, {3, 0}, {5, 2}}), "io") << "over two corners";
  EXPECT_EQ(passed(square(), {{1, -2}, {2, -1}, {3, 0}}), "i") << "a step ends on the corner";
  for (const std::vector<Vec2>& path : {std::vector<Vec2>{{1, 0}, {2, -1}, {3, -2}},
                                        {{1, 0}, {3, -2}},
                                        {{2, -3}, {2, 3}},
                                        {{2, -3}, {2, 0}, {2, 3}},
                                        {{0, 0}, {2, 0}, {2, 3}},
                                        {{0, 0}, {2, 0}, {0, 0.5}},
                                        {{0, 1}, {6, 1}},
                                        {{3, 0}, {4, 0}, {4, 3}},
                                        {{3, 0}, {4, 0}, {5, 0}}}) {
    const std::string ways = passed(square(), path);
    const bool starts_inside = path.front() == Vec2(3, 0);
    const std::string expected = starts_inside ? "oioio" : "ioioi";
    EXPECT_EQ(ways, expected.substr(0, ways.size()));
    EXPECT_EQ(ways.size() % 2 == 1, starts_inside) << "all paths end outside";
  }
}

// Any path: the last word tells where it ends, by another way of finding that.
TEST_P(RingBarrier, TheCountTellsWhereAnyPathEnds) {
  Barrier ring{"c", {{0, 0}, {6, 0}, {6, 5}, {4, 5}, {4, 2}, {2, 2}, {2, 5}, {0, 5}, {0, 0}}};
  if (!GetParam()) std::reverse(ring.vertices.begin(), ring.vertices.end());
  const auto inside = [](const Vec2& p) {
    const auto within = [](double value, double low, double high) {
      return value > low && value < high;
    };
    return within(p.x(), 0, 6) && within(p.y(), 0, 5) && !(within(p.x(), 2, 4) && p.y() > 2);
  };
  Random random(5);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Vec2> path;
    // Every other path runs over a grid that holds the corners.
    for (int i = 0; i < 8; ++i) {
      Vec2 point(random.uniform(-2, 8), random.uniform(-2, 8));
      if (trial % 2 == 0) point = point.array().round();
      path.push_back(point);
    }
    path.front() = Vec2(-1.5, -1.5);
    path.push_back({random.uniform(-2, 8), random.uniform(-2, 8)});
    const std::string ways = passed(ring, path);
    for (std::size_t i = 0; i < ways.size(); ++i) EXPECT_EQ(ways[i], i % 2 == 0 ? 'i' : 'o');
    EXPECT_EQ(ways.size() % 2 == 1, inside(path.back())) << trial;
  }
}

INSTANTIATE_TEST_SUITE_P(BothWays, RingBarrier, testing::Bool(),
                         [](const testing::TestParamInfo<bool>& way) {
                           return way.param ? "counter_clockwise" : "clockwise";
                         });

}  // namespace
}  // namespace clast
