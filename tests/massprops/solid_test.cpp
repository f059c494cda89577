#include "massprops/solid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "tests/shapes/shape_samples.hpp"

namespace clast {
namespace {

TEST(Solid, BoxMatchesTheTextbook) {
  const Vec3 sides(1.0, 2.0, 3.0);
  const MassProperties box = solid_mass_properties(box_mesh(sides, 3), 2500.0);
  EXPECT_NEAR(box.volume, 6.0, 1e-13);
  EXPECT_NEAR(box.mass, 15000.0, 1e-9);
  EXPECT_TRUE(box.centre.isApprox(0.5 * sides, 1e-14));
  const Mat3 expected = (15000.0 / 12.0) * Vec3(13.0, 10.0, 5.0).asDiagonal().toDenseMatrix();
  EXPECT_TRUE(box.inertia.isApprox(expected, 1e-13));
  EXPECT_EQ(box.relative_error, 0.0);
}

// int x^2 = 1/60, int xy = 1/120, centre 1/4, volume 1/6.
TEST(Solid, CornerTetrahedronMatchesItsIntegrals) {
  const MassProperties t = solid_mass_properties(tetrahedron(), 1.0);
  EXPECT_NEAR(t.volume, 1.0 / 6.0, 1e-16);
  EXPECT_TRUE(t.centre.isApprox(Vec3::Constant(0.25), 1e-15));
  const double diagonal = 2.0 * (1.0 / 60.0 - 1.0 / 96.0);
  const double product = -(1.0 / 120.0 - 1.0 / 96.0);
  EXPECT_NEAR(t.inertia(0, 0), diagonal, 1e-16);
  EXPECT_NEAR(t.inertia(0, 1), product, 1e-16);
}

class RigidMotion : public testing::TestWithParam<unsigned> {};

TEST_P(RigidMotion, TurnsTheTensorAndMovesTheCentre) {
  const TriangleMesh rock = random_rock(GetParam(), 2, 0.3);
  Random random(GetParam());
  const Pose motion{Vec3(3.0, -20.0, 7.0), random.rotation()};
  const MassProperties before = solid_mass_properties(rock, 2650.0);
  const MassProperties after = solid_mass_properties(transformed(rock, motion), 2650.0);
  const Mat3 turn = motion.rotation.toRotationMatrix();
  EXPECT_NEAR(after.volume / before.volume, 1.0, 1e-13);
  EXPECT_TRUE(after.centre.isApprox(motion * before.centre, 1e-13));
  EXPECT_TRUE(after.inertia.isApprox(turn * before.inertia * turn.transpose(), 1e-12));
}

TEST_P(RigidMotion, MapCoordinatesCostNoDigits) {
  TriangleMesh rock = random_rock(GetParam(), 3, 0.2);
  // On the grid of doubles near 5e6, so that the shifted rock is the same rock.
  for (Vec3& v : rock.vertices) v = (v * 0x1p30).array().round().matrix() * 0x1p-30;
  TriangleMesh far = rock;
  const Vec3 shift(5e6, 5e6, 4e6);
  for (Vec3& v : far.vertices) v += shift;
  const MassProperties near = solid_mass_properties(rock, 1.0);
  const MassProperties shifted = solid_mass_properties(far, 1.0);
  EXPECT_NEAR(shifted.volume / near.volume, 1.0, 1e-12);
  EXPECT_TRUE(shifted.inertia.isApprox(near.inertia, 1e-12));
  EXPECT_LT((shifted.centre - shift - near.centre).norm(), 2e-9);
}

INSTANTIATE_TEST_SUITE_P(RandomRocks, RigidMotion, testing::Range(0u, 20u));

TEST(Solid, CavityIsTakenAway) {
  TriangleMesh bubble = box_mesh(Vec3::Constant(0.5));
  for (auto& t : bubble.triangles) std::swap(t[0], t[1]);
  for (Vec3& v : bubble.vertices) v += Vec3(0.1, 0.2, 0.3);
  const TriangleMesh hollow = merged(box_mesh(Vec3::Ones()), bubble);
  const MassProperties properties = solid_mass_properties(hollow, 1.0);
  EXPECT_NEAR(properties.volume, 1.0 - 0.125, 1e-14);
  const Vec3 bubble_centre = Vec3(0.35, 0.45, 0.55);
  EXPECT_TRUE(
      properties.centre.isApprox((Vec3::Constant(0.5) - 0.125 * bubble_centre) / 0.875, 1e-14));
}

TEST(Solid, WhatBoundsNoSolidIsRefused) {
  TriangleMesh open = box_mesh(Vec3::Ones());
  open.triangles.pop_back();
  EXPECT_THROW(solid_mass_properties(open, 1.0), GeometryError);

  TriangleMesh inward = box_mesh(Vec3::Ones());
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_THROW(solid_mass_properties(inward, 1.0), GeometryError);

  TriangleMesh one_flipped = box_mesh(Vec3::Ones());
  std::swap(one_flipped.triangles[3][0], one_flipped.triangles[3][1]);
  EXPECT_THROW(solid_mass_properties(one_flipped, 1.0), GeometryError);

  EXPECT_THROW(solid_mass_properties(TriangleMesh{}, 1.0), GeometryError);

  TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.triangles = {{0, 1, 2}, {0, 2, 1}};
  EXPECT_THROW(solid_mass_properties(flat, 1.0), GeometryError);
}

TEST(Solid, DensityMustBePositiveAndFinite) {
  for (const double density : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(solid_mass_properties(tetrahedron(), density), InputError);
  }
}

TEST(SignedVolume, ChangesSignWithTheWinding) {
  TriangleMesh mesh = random_rock(5, 2, 0.2);
  const double outward = signed_volume(mesh);
  EXPECT_NEAR(outward, enclosed_volume(mesh), 1e-13);
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(signed_volume(mesh), -outward, 1e-13);
  EXPECT_EQ(signed_volume(TriangleMesh{}), 0.0);
}

}  // namespace
}  // namespace clast
