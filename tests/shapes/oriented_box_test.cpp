#include "shapes/oriented_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/detail/calipers.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

const Pose kMotion{Vec3(100.0, -40.0, 7.0), Quat(0.5, -0.3, 0.7, 0.2).normalized()};

std::vector<Vec3> moved(std::vector<Vec3> points, const Pose& motion) {
  for (Vec3& p : points) p = motion * p;
  return points;
}

std::vector<Vec3> random_points(std::uint64_t seed, int count) {
  Random random(seed);
  const Vec3 axes(1.0, random.uniform(0.3, 1.0), random.uniform(0.2, 1.0));
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(
        seed % 2
            ? Vec3(random.unit_vector().cwiseProduct(axes))
            : Vec3(Vec3(random.normal(), random.normal(), random.normal()).cwiseProduct(axes)));
  }
  return points;
}

/// Every point inside, every side touched, axes right-handed and orthonormal.
void expect_tight(const OrientedBox& box, const std::vector<Vec3>& points, double radius) {
  EXPECT_TRUE((box.axes.transpose() * box.axes).isApprox(Mat3::Identity(), 1e-13));
  EXPECT_NEAR(box.axes.determinant(), 1.0, 1e-13);
  EXPECT_GE(box.lengths[0], box.lengths[1]);
  EXPECT_GE(box.lengths[1], box.lengths[2]);
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& p : points) {
    const Vec3 local = box.axes.transpose() * (p - box.centre);
    low = low.cwiseMin(local);
    high = high.cwiseMax(local);
  }
  const double slack = 1e-12 * (box.lengths[0] + box.centre.norm());
  EXPECT_LT((high - (0.5 * box.lengths - Vec3::Constant(radius))).cwiseAbs().maxCoeff(), slack);
  EXPECT_LT((low + (0.5 * box.lengths - Vec3::Constant(radius))).cwiseAbs().maxCoeff(), slack);
}

TEST(SmallestBox, TurnedCuboidIsItsOwnBox) {
  for (const int cells : {1, 4}) {
    const std::vector<Vec3> points = moved(box_mesh(Vec3(2, 3, 1), cells).vertices, kMotion);
    const OrientedBox box = smallest_box(points);
    EXPECT_TRUE(box.lengths.isApprox(Vec3(3, 2, 1), 1e-12));
    EXPECT_LT((box.centre - kMotion * Vec3(1, 1.5, 0.5)).norm(), 1e-12);
    const Mat3 turn = kMotion.rotation.toRotationMatrix();
    EXPECT_NEAR(std::abs(box.axes.col(0).dot(turn.col(1))), 1.0, 1e-12);
    expect_tight(box, points, 0.0);
  }
}

// Four corners of a cube make a regular tetrahedron; no box around it is smaller than that cube.
TEST(SmallestBox, RegularTetrahedronSitsInACube) {
  const std::vector<Vec3> points =
      moved({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, kMotion);
  const OrientedBox box = smallest_box(points);
  EXPECT_TRUE(box.lengths.isApprox(Vec3::Constant(2.0), 1e-9));
}

// Standing on a vertex and turned by 45 degrees its shadow is a square of side sqrt 2, its
// height 2.
TEST(SmallestBox, OctahedronIsNoLargerThanItsUprightBox) {
  const std::vector<Vec3> points = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                    {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  EXPECT_LE(smallest_box(moved(points, kMotion)).volume(), 4.0 * (1.0 + 1e-12));
}

class RandomHull : public testing::TestWithParam<int> {};

TEST_P(RandomHull, NoRotationOfManyGivesASmallerBox) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  Random random(1000 + seed);
  const std::vector<Vec3> points =
      random_points(seed, 8 + static_cast<int>(random.uniform_index(60)));
  const double radius = seed % 3 == 0 ? 0.0 : random.uniform(0.0, 0.4);
  const OrientedBox box = smallest_box(points, radius);
  expect_tight(box, points, radius);

  const std::vector<Vec3> corners = convex_hull(points).vertices;
  double best = 1e300;
  Mat3 best_axes = Mat3::Identity();
  for (int i = 0; i < 20000; ++i) {
    const Mat3 axes = random.rotation().toRotationMatrix();
    const double volume = box_with_axes(corners, axes, radius).volume();
    if (volume < best) {
      best = volume;
      best_axes = axes;
    }
  }
  // Downhill from the best of them by ever smaller random turns.
  double reach = 0.1;
  for (int i = 0; i < 6000; ++i) {
    const Vec3 turn = reach * random.uniform() * random.unit_vector();
    const Mat3 axes = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * best_axes;
    const double volume = box_with_axes(corners, axes, radius).volume();
    if (volume < best) {
      best = volume;
      best_axes = axes;
    } else {
      reach = std::max(reach * 0.997, 1e-8);
    }
  }
  EXPECT_LE(box.volume(), best * (1.0 + 1e-9));
}

TEST_P(RandomHull, SameBitsForAnyOrderOfThePoints) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  std::vector<Vec3> points = random_points(seed, 80);
  const OrientedBox box = smallest_box(points, 0.1);
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) {
    std::swap(points[i - 1], points[random.uniform_index(i)]);
  }
  points.push_back(points.front());  // a repeated point is nothing new
  const OrientedBox other = smallest_box(points, 0.1);
  EXPECT_TRUE(box.lengths == other.lengths);
  EXPECT_TRUE(box.axes == other.axes);
  EXPECT_TRUE(box.centre == other.centre);
}

TEST_P(RandomHull, TurnsAndScalesWithTheBody) {
  const std::vector<Vec3> points = random_points(static_cast<std::uint64_t>(GetParam()), 60);
  const OrientedBox box = smallest_box(points);
  const OrientedBox turned = smallest_box(moved(points, kMotion));
  EXPECT_NEAR(turned.volume() / box.volume(), 1.0, 1e-9);
  std::vector<Vec3> larger = points;
  for (Vec3& p : larger) p *= 8.0;
  EXPECT_TRUE(smallest_box(larger).lengths.isApprox(8.0 * box.lengths, 1e-12));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomHull, testing::Range(0, 12));

// The radius changes which direction is smallest, so the search must know it.
TEST(SmallestBox, OfARoundedBodyIsNeverAboveTheCoresBoxGrown) {
  bool smaller_once = false;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::vector<Vec3> points = random_points(seed, 10);
    const OrientedBox core = smallest_box(points);
    const double radius = 0.3 * core.lengths[2];
    const double grown = (core.lengths + Vec3::Constant(2.0 * radius)).prod();
    const double volume = smallest_box(points, radius).volume();
    EXPECT_LE(volume, grown * (1.0 + 1e-11));
    smaller_once = smaller_once || volume < grown * (1.0 - 1e-6);
  }
  EXPECT_TRUE(smaller_once);
}

TEST(SmallestBox, FlatStraightAndSinglePointsHaveABox) {
  const std::vector<Vec3> plane =
      moved({{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}, {2, 0.5, 0}}, kMotion);
  const OrientedBox flat = smallest_box(plane, 0.1);
  EXPECT_TRUE(flat.lengths.isApprox(Vec3(4.2, 1.2, 0.2), 1e-12));
  EXPECT_LT((flat.centre - kMotion * Vec3(2, 0.5, 0)).norm(), 1e-12);
  EXPECT_EQ(smallest_box(plane).lengths[2], 0.0);

  const std::vector<Vec3> line = moved({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, kMotion);
  EXPECT_TRUE(smallest_box(line).lengths.isApprox(Vec3(std::sqrt(27.0), 0, 0), 1e-12));

  const std::vector<Vec3> point = {Vec3(1, 2, 3)};
  const OrientedBox dot = smallest_box(point, 0.5);
  EXPECT_TRUE(dot.lengths == Vec3::Ones());
  EXPECT_TRUE(dot.centre == Vec3(1, 2, 3));
}

// The hull has a face of no area, with the normal opposite to that of the next: halfway between
// them is no direction at all, and the box along it was 0 m long.
TEST(SmallestBox, OfAFlatBottomWithPointsInLineHoldsTheBody) {
  const std::vector<Vec3> points = {
      {-0.22321286918075578, -0.0040320922956814664, 0.23971931243769801},
      {-0.20993193925521486, 0.027107210676579594, -0.22791337322977762},
      {-0.20245971080795858, 0.071864106312009957, -0.22791337322977762},
      {-0.19941207072774478, 0.090118755506329987, -0.22791337322977762},
      {-0.19709413459496977, -0.18263381319100891, -0.22791337322977762},
      {0.4057127559977618, 0.054859800166242506, 0.049437688363852622}};
  expect_tight(smallest_box(points), points, 0.0);
}

// Cut faces: many points in a plane, and of these many in lines.
TEST(SmallestBox, OfBodiesCutByPlanesHoldsTheBody) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i) points.push_back(random.unit_vector());
    const Vec3 from(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), -1.0);
    const Vec3 to(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), -1.0);
    for (int i = 0; i < 5; ++i) points.push_back(from + random.uniform() * (to - from));
    expect_tight(smallest_box(points), points, 0.0);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(SmallestBox, BadInputIsRefused) {
  EXPECT_THROW(smallest_box(std::vector<Vec3>{}), GeometryError);
  EXPECT_THROW(smallest_box(std::vector<Vec3>{Vec3(0, 0, std::nan(""))}), GeometryError);
  EXPECT_THROW(smallest_box(std::vector<Vec3>{Vec3(0, 0, 0)}, -1.0), InputError);
}

TEST(BoxAlong, SidesAreSortedAndAxesFollow) {
  const std::vector<Vec3> points = box_mesh(Vec3(1, 3, 2)).vertices;
  const OrientedBox box = box_with_axes(points, Mat3::Identity(), 0.25);
  EXPECT_TRUE(box.lengths.isApprox(Vec3(3.5, 2.5, 1.5), 1e-15));
  EXPECT_TRUE(box.axes.col(0) == Vec3::UnitY());
  EXPECT_TRUE(box.axes.col(1) == Vec3::UnitZ());
  EXPECT_TRUE(box.axes.col(2) == Vec3::UnitX());
  EXPECT_TRUE(box.centre == Vec3(0.5, 1.5, 1.0));
}

TEST(SmallestRectangle, NoAngleGivesASmallerOne) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    std::vector<Vec2> points;
    for (int i = 0; i < 30; ++i) points.emplace_back(random.normal(), 0.5 * random.normal());
    const double radius = seed % 2 ? 0.3 : 0.0;
    const EnclosingRectangle best = smallest_rectangle(points, radius);
    for (int step = 0; step < 2000; ++step) {
      const double angle = kPi / 2 * step / 2000;
      const Vec2 u(std::cos(angle), std::sin(angle)), v(-u.y(), u.x());
      double low_u = 1e300, high_u = -1e300, low_v = 1e300, high_v = -1e300;
      for (const Vec2& p : points) {
        low_u = std::min(low_u, u.dot(p));
        high_u = std::max(high_u, u.dot(p));
        low_v = std::min(low_v, v.dot(p));
        high_v = std::max(high_v, v.dot(p));
      }
      EXPECT_LE(best.area(),
                (high_u - low_u + 2 * radius) * (high_v - low_v + 2 * radius) * (1.0 + 1e-12));
    }
  }
}

// Turned prisms are seen on edge by many directions, where rounding alone tells their walls up or
// down.
TEST(SmallestBox, OfTurnedPrismsIsExact) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Quat turn = Random(seed).rotation();
    std::vector<Vec3> bar, l;
    for (int k = 0; k < 8; ++k) bar.push_back(turn * Vec3(k & 1, (k >> 1) & 1, 2 * ((k >> 2) & 1)));
    for (const Vec3& v : l_block().vertices) l.push_back(turn * v);
    EXPECT_LT((smallest_box(bar, 0.1).lengths - Vec3(2.2, 1.2, 1.2)).norm(), 1e-11) << seed;
    EXPECT_LT((smallest_box(l, 0.05).lengths - Vec3(2.1, 2.1, 1.1)).norm(), 1e-11) << seed;
  }
}

}  // namespace
}  // namespace clast
