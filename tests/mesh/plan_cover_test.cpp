#include "mesh/plan_cover.hpp"

#include <gtest/gtest.h>

#include "mesh/geodesic_sphere.hpp"

namespace clast {
namespace {

TriangleMesh ball(double radius, const Vec3& centre) {
  TriangleMesh mesh = scaled(geodesic_sphere(16), radius);
  for (Vec3& vertex : mesh.vertices) vertex += centre;
  return mesh;
}

std::vector<PlanCover> cover(const std::vector<TriangleMesh>& bodies) {
  std::vector<const TriangleMesh*> all;
  for (const TriangleMesh& body : bodies) all.push_back(&body);
  return measure_plan_cover(all);
}

TEST(PlanCover, ABallCoversItsDisc) {
  const std::vector<PlanCover> covers = cover({ball(0.5, {3.0, -2.0, 1.0})});
  EXPECT_NEAR(covers[0].area, kPi * 0.25, 0.02);
  EXPECT_EQ(covers[0].area, covers[0].exposed);
}

TEST(PlanCover, WhatLiesBelowAnotherBodyIsNotExposed) {
  const std::vector<PlanCover> covers =
      cover({ball(0.5, {0.0, 0.0, 0.0}), ball(1.0, {0.0, 0.0, 2.0}), ball(0.5, {5.0, 0.0, 0.0})});
  EXPECT_EQ(covers[0].exposed, 0.0);
  EXPECT_NEAR(covers[0].area, covers[2].area, 0.02);
  EXPECT_EQ(covers[1].area, covers[1].exposed);
  EXPECT_EQ(covers[2].area, covers[2].exposed);
}

TEST(PlanCover, DoesNotDependOnTheOrderOfBodies) {
  const TriangleMesh low = ball(0.6, {0.0, 0.0, 0.0}), high = ball(0.6, {0.5, 0.1, 0.7});
  const std::vector<PlanCover> a = cover({low, high}), b = cover({high, low});
  EXPECT_EQ(a[0].exposed, b[1].exposed);
  EXPECT_EQ(a[1].exposed, b[0].exposed);
  EXPECT_LT(a[0].exposed, 0.8 * a[0].area);
}

TEST(PlanCover, OfNoBodiesThereIsNone) { EXPECT_TRUE(measure_plan_cover({}).empty()); }

}  // namespace
}  // namespace clast
