#include "classify/equilibria.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "massprops/solid.hpp"
#include "shapes/convex_hull.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

const Pose kSomeMotion{Vec3(3, -2, 5), Quat(0.5, -0.3, 0.7, 0.2).normalized()};

/// Equilibria of the hull of points, about its own centre of mass, at another place.
StaticEquilibriumCounts equilibria(const std::vector<Vec3>& points, double radius = 0.1) {
  const TriangleMesh hull = transformed(convex_hull(points), kSomeMotion);
  return count_static_equilibria(make_sphero_polyhedron(hull, radius),
                                 solid_mass_properties(hull, 1.0).centre);
}

void expect_counts(const StaticEquilibriumCounts& e, std::size_t S, std::size_t U, std::size_t H) {
  EXPECT_EQ(e.stable, S);
  EXPECT_EQ(e.unstable, U);
  EXPECT_EQ(e.saddle, H);
  EXPECT_TRUE(e.is_consistent());
}

// A regular polyhedron stands on each face, each vertex and each edge.
TEST(Equilibria, OfTheRegularPolyhedra) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Vec3> cube, icosahedron, dodecahedron;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      icosahedron.insert(icosahedron.end(), {{0, x, y * g}, {x, y * g, 0}, {y * g, 0, x}});
      dodecahedron.insert(dodecahedron.end(),
                          {{0, x / g, y * g}, {x / g, y * g, 0}, {y * g, 0, x / g}});
      for (const double z : {-1.0, 1.0}) cube.emplace_back(x, y, z);
    }
  }
  dodecahedron.insert(dodecahedron.end(), cube.begin(), cube.end());
  expect_counts(equilibria({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}), 4, 4, 6);
  expect_counts(equilibria(cube), 6, 8, 12);
  expect_counts(equilibria({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}),
                8, 6, 12);
  expect_counts(equilibria(dodecahedron), 12, 20, 30);
  expect_counts(equilibria(icosahedron), 20, 12, 30);
}

TEST(Equilibria, OfACuboidAreThoseOfACubeHoweverItsFacesAreCut) {
  expect_counts(equilibria(box_mesh(Vec3(5, 2, 1)).vertices), 6, 8, 12);
  expect_counts(equilibria(box_mesh(Vec3(1, 1, 40), 4).vertices), 6, 8, 12);
}

// A prism over a regular pentagon stands on 5 sides and 2 ends; cut off obliquely enough it can't
// stand on its ends any more.
TEST(Equilibria, ALeaningPrismDoesNotStandOnItsEnds) {
  std::vector<Vec3> upright, leaning;
  for (int i = 0; i < 5; ++i) {
    const Vec3 corner(std::cos(2 * kPi * i / 5), std::sin(2 * kPi * i / 5), 0);
    for (const double end : {-2.0, 2.0}) {
      upright.push_back(corner + end * Vec3::UnitZ());
      leaning.push_back(corner + end * Vec3(1.1, 0, 1));
    }
  }
  expect_counts(equilibria(upright), 7, 10, 15);
  const StaticEquilibriumCounts leans = equilibria(leaning);
  EXPECT_LT(leans.stable, 6u);
  EXPECT_TRUE(leans.is_consistent());
}

// A triaxial ellipsoid has two of each. On a mesh of it each becomes a flock, symmetric as the
// ellipsoid is, with the same balance.
TEST(Equilibria, OfAMeshedEllipsoidComeInFlocks) {
  std::vector<Vec3> points = {{0, 0, 1.8}, {0, 0, -1.8}};
  for (int i = 1; i < 30; ++i) {
    for (int j = 0; j < 60; ++j) {
      const double polar = kPi * i / 30, azimuth = kPi * j / 30;
      points.emplace_back(1.1 * std::sin(polar) * std::cos(azimuth),
                          0.6 * std::sin(polar) * std::sin(azimuth), 1.8 * std::cos(polar));
    }
  }
  const StaticEquilibriumCounts e = equilibria(points);
  EXPECT_GE(e.unstable, 2u);
  EXPECT_GE(e.stable, 2u);
  EXPECT_EQ(e.unstable % 2, 0u);
  EXPECT_TRUE(e.is_consistent());
}

TEST(Equilibria, PoincareHopfHoldsForAnyCentreInside) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    std::vector<Vec3> points;
    const std::uint64_t count = 5 + random.uniform_index(60);
    for (std::uint64_t i = 0; i < count; ++i) {
      points.push_back(random.unit_vector().cwiseProduct(Vec3(1.0, 0.8, 0.5)) *
                       random.uniform(0.6, 1.0));
    }
    const TriangleMesh hull = convex_hull(points);
    const Vec3 middle = solid_mass_properties(hull, 1.0).centre;
    const Vec3 centre = middle + 0.5 * random.uniform() * (points[0] - middle);
    const StaticEquilibriumCounts e =
        count_static_equilibria(make_sphero_polyhedron(hull, 0.1), centre);
    EXPECT_TRUE(e.is_consistent())
        << "seed " << seed << ": " << e.stable << " " << e.unstable << " " << e.saddle;
    EXPECT_GE(e.stable, 1u);
    EXPECT_GE(e.unstable, 1u);
  }
}

TEST(Equilibria, OfWhatEnclosesNoVolumeAreRefused) {
  SpheroPolyhedron flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_THROW(count_static_equilibria(flat, Vec3::Zero()), GeometryError);
}

}  // namespace
}  // namespace clast
