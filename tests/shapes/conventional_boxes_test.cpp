#include "shapes/conventional_boxes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "shapes/convex_hull.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

const Pose kBoxMotion{Vec3(20.0, -4.0, 7.0), Quat(0.5, -0.3, 0.7, 0.2).normalized()};

std::vector<Vec3> moved_points(std::vector<Vec3> points) {
  for (Vec3& p : points) p = kBoxMotion * p;
  return points;
}

/// Points on an ellipsoid with these half axes, symmetric about its three planes.
std::vector<Vec3> ellipsoid(const Vec3& half_axes) {
  std::vector<Vec3> points;
  const int n = 24;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < 2 * n; ++j) {
      const double polar = kPi * i / n, azimuth = kPi * j / n;
      points.push_back(Vec3(std::sin(polar) * std::cos(azimuth),
                            std::sin(polar) * std::sin(azimuth), std::cos(polar))
                           .cwiseProduct(half_axes));
    }
  }
  return points;
}

std::vector<Vec3> random_box_points(std::uint64_t seed, int count = 60) {
  Random random(seed);
  const Vec3 axes(1.0, random.uniform(0.3, 1.0), random.uniform(0.2, 1.0));
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(random.unit_vector().cwiseProduct(axes));
  return points;
}

using Rule = OrientedBox (*)(std::span<const Vec3>, double);
const std::vector<Rule> kRules = {smallest_box, feret_box, pca_box};

// A cube across its diagonal: the shadow is a regular hexagon with corners sqrt(2/3) a from its
// centre, 2 sqrt(2/3) a from corner to corner and sqrt(3) sqrt(2/3) a from side to side.
TEST(FeretBox, OfACubeStandsOnADiagonal) {
  for (const double a : {1.0, 0.3}) {
    for (const double radius : {0.0, 0.1}) {
      const auto points = moved_points(box_mesh(Vec3::Constant(a), 2).vertices);
      const Vec3 expected = a * Vec3(std::sqrt(3.0), 2.0 * std::sqrt(2.0 / 3.0), std::sqrt(2.0)) +
                            Vec3::Constant(2.0 * radius);
      EXPECT_TRUE(feret_box(points, radius).lengths.isApprox(expected, 1e-12));
    }
  }
}

// A flat cuboid a x b x c has L = D = sqrt(a^2 + b^2 + c^2) along any of its four diagonals. Across
// a diagonal the corner at (a, b, -c) less (0, 0, c) is the farthest of the three other diagonals.
TEST(FeretBox, OfACuboidIsItsDiagonalAndTheLongestOfTheOthersAcrossIt) {
  const Vec3 sides(3.0, 2.0, 1.0);
  const double D2 = sides.squaredNorm();
  double widest = 0.0;
  for (int i = 0; i < 3; ++i) {
    Vec3 other = sides;
    other[i] = -other[i];
    const double along = other.dot(sides) / std::sqrt(D2);
    widest = std::max(widest, std::sqrt(D2 - along * along));
  }
  const OrientedBox box = feret_box(moved_points(box_mesh(sides).vertices));
  EXPECT_NEAR(box.lengths[0], std::sqrt(D2), 1e-12);
  EXPECT_NEAR(box.lengths[1], widest, 1e-12);
}

TEST(FeretBox, HoldsTheLongestDistanceAndTheLongestWidthAcrossIt) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<Vec3> points = random_box_points(seed);
    const double radius = seed % 2 ? 0.2 : 0.0;
    const OrientedBox box = feret_box(points, radius);
    double longest = 0.0, widest = 0.0, depth = 0.0;
    for (const Vec3& p : points) {
      for (const Vec3& q : points) {
        const Vec3 d = p - q;
        longest = std::max(longest, d.norm());
        widest = std::max(widest, (d - d.dot(box.axes.col(0)) * box.axes.col(0)).norm());
        depth = std::max(depth, std::abs(d.dot(box.axes.col(2))));
      }
    }
    EXPECT_NEAR(box.lengths[0], longest + 2 * radius, 1e-12) << "seed " << seed;
    EXPECT_NEAR(box.lengths[1], widest + 2 * radius, 1e-12) << "seed " << seed;
    EXPECT_NEAR(box.lengths[2], depth + 2 * radius, 1e-12) << "seed " << seed;
  }
}

TEST(ConventionalBoxes, OfAnEllipsoidAreItsAxesWhateverTheRule) {
  const auto points = moved_points(ellipsoid({0.7, 2.0, 1.2}));
  const Vec3 longest = kBoxMotion.rotation * Vec3::UnitY();
  for (const double radius : {0.0, 0.25}) {
    const Vec3 expected = Vec3(4.0, 2.4, 1.4) + Vec3::Constant(2 * radius);
    for (const Rule rule : {feret_box, pca_box}) {
      const OrientedBox box = rule(points, radius);
      EXPECT_TRUE(box.lengths.isApprox(expected, 1e-12)) << box.lengths.transpose();
      EXPECT_NEAR(std::abs(box.axes.col(0).dot(longest)), 1.0, 1e-12);
    }
    // Flush with facets 3.75 degrees off the poles it is smaller, by 1 - cos(3.75 degrees) at most.
    const OrientedBox smallest = smallest_box(points, radius);
    EXPECT_TRUE((smallest.lengths.array() >= (1.0 - 2.2e-3) * expected.array()).all());
    EXPECT_TRUE((smallest.lengths.array() <= expected.array()).all());
  }
}

TEST(PcaBox, OfACuboidIsTheCuboid) {
  const OrientedBox box = pca_box(moved_points(box_mesh(Vec3(3, 2, 1)).vertices), 0.1);
  EXPECT_TRUE(box.lengths.isApprox(Vec3(3.2, 2.2, 1.2), 1e-12));
  EXPECT_LT((box.centre - kBoxMotion * Vec3(1.5, 1.0, 0.5)).norm(), 1e-12);
}

// Two corners close to one corner of a cuboid weigh it down: the axes follow the corners.
TEST(PcaBox, FollowsTheCornersOfTheHullAndNotPointsInside) {
  std::vector<Vec3> points = box_mesh(Vec3(3, 2, 1)).vertices;
  const OrientedBox bare = pca_box(points);
  for (int i = 1; i < 100; ++i) points.emplace_back(0.02 * i, 0.015 * i, 0.005 * i);
  EXPECT_TRUE(pca_box(points).axes == bare.axes);
  points.emplace_back(3.0, 2.1, 1.05);
  points.emplace_back(3.05, 2.0, 1.05);
  EXPECT_GT(pca_box(points).volume(), 1.05 * smallest_box(points).volume());
}

// Along the given axes unless two or three moments agree: then the body is free to turn.
TEST(PrincipalBox, TakesTheSmallestBoxThatFreeAxesAllow) {
  const auto points = box_mesh(Vec3(1, 1, 3)).vertices;
  const Mat3 turned = Eigen::AngleAxisd(0.3, Vec3::UnitZ()).toRotationMatrix();
  const double wide = std::cos(0.3) + std::sin(0.3);
  EXPECT_TRUE(
      principal_box(points, turned, {1, 2, 3}).lengths.isApprox(Vec3(3, wide, wide), 1e-12));
  EXPECT_TRUE(principal_box(points, turned, {2, 2, 3}).lengths.isApprox(Vec3(3, 1, 1), 1e-12));
  EXPECT_TRUE(
      principal_box(points, turned, {2, 2, 2 + 1e-6}).lengths.isApprox(Vec3(3, 1, 1), 1e-12));
  Mat3 z_first;
  z_first << turned.col(2), turned.col(0), turned.col(1);
  EXPECT_TRUE(principal_box(points, z_first, {1, 2, 2}).lengths.isApprox(Vec3(3, 1, 1), 1e-12));
  const Mat3 askew = Quat(0.5, -0.3, 0.7, 0.2).normalized().toRotationMatrix();
  EXPECT_TRUE(principal_box(points, askew, {2, 2, 2}).lengths.isApprox(Vec3(3, 1, 1), 1e-9));
}

TEST(ConventionalBoxes, OfASquarePrismDoNotDependOnHowItLies) {
  const auto points = box_mesh(Vec3(1, 1, 3)).vertices;
  for (const Rule rule : kRules) {
    const Vec3 turned = rule(moved_points(points), 0.1).lengths,
               upright = rule(points, 0.1).lengths;
    EXPECT_TRUE(turned.isApprox(upright, 1e-9))
        << turned.transpose() << "; " << upright.transpose();
  }
}

class RandomPoints : public testing::TestWithParam<int> {};

TEST_P(RandomPoints, GiveNoBoxSmallerThanTheSmallest) {
  const auto points = random_box_points(static_cast<std::uint64_t>(GetParam()));
  for (const double radius : {0.0, 0.3}) {
    const double least = smallest_box(points, radius).volume();
    EXPECT_GE(feret_box(points, radius).volume(), least * (1.0 - 1e-9));
    EXPECT_GE(pca_box(points, radius).volume(), least * (1.0 - 1e-9));
  }
}

TEST_P(RandomPoints, GiveTheSameBitsInAnyOrder) {
  auto points = random_box_points(static_cast<std::uint64_t>(GetParam()));
  std::vector<OrientedBox> before;
  for (const Rule rule : kRules) before.push_back(rule(points, 0.1));
  Random random(7);
  for (std::size_t i = points.size(); i > 1; --i) {
    std::swap(points[i - 1], points[random.uniform_index(i)]);
  }
  points.push_back(points[3]);
  for (std::size_t i = 0; i < kRules.size(); ++i) {
    const OrientedBox box = kRules[i](points, 0.1);
    EXPECT_TRUE(box.lengths == before[i].lengths && box.axes == before[i].axes &&
                box.centre == before[i].centre)
        << "rule " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPoints, testing::Range(0, 10));

TEST(ConventionalBoxes, AreTheSameBitsOnOneAndTwoThreads) {
  constexpr std::size_t kBodies = 12;
  const auto boxes = [&](unsigned threads) {
    std::vector<OrientedBox> found(kRules.size() * kBodies);
    parallel_for(found.size(), threads, [&](std::size_t i) {
      found[i] = kRules[i % kRules.size()](random_box_points(i / kRules.size()), 0.05);
    });
    return found;
  };
  const auto one = boxes(1), two = boxes(2);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_TRUE(one[i].lengths == two[i].lengths && one[i].axes == two[i].axes &&
                one[i].centre == two[i].centre)
        << i;
  }
}

TEST(ConventionalBoxes, OfFlatStraightAndSinglePointsAreFlat) {
  const std::vector<Vec3> plane =
      moved_points({{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}, {2, 0.5, 0}});
  for (const Rule rule : kRules) {
    const OrientedBox flat = rule(plane, 0.0);
    EXPECT_EQ(flat.lengths[2], 0.0);
    EXPECT_GT(flat.lengths[1], 0.9);
    EXPECT_LT((flat.centre - kBoxMotion * Vec3(2, 0.5, 0)).norm(), 1e-12);
    EXPECT_EQ(rule(plane, 0.1).lengths[2], 0.2);

    const OrientedBox line = rule(moved_points({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}), 0.1);
    EXPECT_TRUE(line.lengths.isApprox(Vec3(std::sqrt(27.0) + 0.2, 0.2, 0.2), 1e-12));
    EXPECT_EQ(line.lengths[2], 0.2);
    EXPECT_TRUE((line.axes.transpose() * line.axes).isApprox(Mat3::Identity(), 1e-12));

    const OrientedBox dot = rule(std::vector<Vec3>{Vec3(1, 2, 3)}, 0.5);
    EXPECT_TRUE(dot.lengths == Vec3::Ones());
    EXPECT_TRUE(dot.centre == Vec3(1, 2, 3));
  }
  // The diagonals of the 4 x 1 rectangle: across one, the other corner is 8 / sqrt 17 away.
  const Vec3 expected(std::sqrt(17.0), 8.0 / std::sqrt(17.0), 0.0);
  EXPECT_TRUE(feret_box(plane).lengths.isApprox(expected, 1e-12));
  EXPECT_TRUE(pca_box(plane).lengths.isApprox(Vec3(4, 1, 0), 1e-12));
}

// Four corners of a cube of side 2: every edge is 2 sqrt 2, two of them cross at right angles at a
// distance of 2.
TEST(ConventionalBoxes, OfFourPointsAreThoseOfATetrahedron) {
  const auto points = moved_points({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  const double edge = 2.0 * std::sqrt(2.0);
  EXPECT_TRUE(
      feret_box(points, 0.1).lengths.isApprox(Vec3(edge, edge, 2.0) + Vec3::Constant(0.2), 1e-12));
  EXPECT_TRUE(pca_box(points, 0.1).lengths.isApprox(Vec3::Constant(2.2), 1e-9));
}

TEST(ConventionalBoxes, OfNothingOrNoNumbersAreRefused) {
  for (const Rule rule : kRules) {
    EXPECT_THROW(rule(std::vector<Vec3>{}, 0.0), GeometryError);
    EXPECT_THROW(rule(std::vector<Vec3>{Vec3(0, 0, std::nan(""))}, 0.0), GeometryError);
    EXPECT_THROW(rule(std::vector<Vec3>{Vec3(0, 0, 0)}, -1.0), InputError);
    EXPECT_THROW(rule(random_box_points(1), -1.0), InputError);
  }
}

TEST(ExtremePoints, AreCornersOfHullOutlineOrLine) {
  EXPECT_EQ(extreme_points(box_mesh(Vec3(1, 2, 3), 4).vertices).size(), 8u);
  const std::vector<Vec3> flat = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}};
  EXPECT_EQ(extreme_points(flat), (std::vector<Vec3>{{0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {2, 2, 0}}));
  const std::vector<Vec3> line = {{1, -1, 0}, {0, 0, 0}, {3, -3, 0}, {0, 0, 0}};
  EXPECT_EQ(extreme_points(line), (std::vector<Vec3>{{0, 0, 0}, {3, -3, 0}}));
  EXPECT_TRUE(extreme_points(std::vector<Vec3>{}).empty());
}

}  // namespace
}  // namespace clast
