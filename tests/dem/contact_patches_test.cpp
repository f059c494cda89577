// How contact points share the stiffness of their patches.
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "dem/contact/contact_patches.hpp"
#include "dem/surface/block_surface.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {

using namespace dem_detail;

namespace {

/// Points under some corners of a cube on three planes of the ground, level or steep.
std::vector<ContactPoint> points_under(const RigidBody& cube, Random& random) {
  std::vector<ContactPoint> points;
  const double share = random.uniform();
  for (std::uint32_t v = 0; v < cube.shape.vertices.size(); ++v) {
    if (random.uniform() > share) continue;
    ContactPoint point;
    point.block_feature = v;
    point.ground_face = static_cast<std::uint32_t>(3.0 * random.uniform());
    const double tilt = 0.9 * point.ground_face;
    point.normal = Vec3(std::sin(tilt), 0.0, std::cos(tilt));
    point.overlap = 0.01 * (1.0 + random.uniform());
    point.surface_point = cube.shape.vertices[v];
    points.push_back(point);
  }
  return points;
}

// What it keeps from call to call spares work and changes no result.
TEST(ContactPatches, DependOnNoEarlierPoints) {
  const RigidBody cube = box(1000.0, Vec3::Ones());
  const BlockSurface surface(cube.shape);
  ContactPatches kept(surface, ContactWeighting::kPatch);
  Random random(7);
  std::size_t joined = 0, apart = 0;
  std::vector<ContactPoint> points;
  for (int call = 0; call < 2000; ++call) {
    if (random.uniform() < 0.5) points = points_under(cube, random);
    const Quat turn(Eigen::AngleAxisd(random.uniform(), Vec3::UnitX()));
    ContactPatches fresh(surface, ContactWeighting::kPatch);
    const std::span<const double> expected = fresh.compute_weights(points, turn);
    const std::span<const double> shares = kept.compute_weights(points, turn);
    ASSERT_EQ(shares.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(shares[i], expected[i]) << call << ", " << i;
      ASSERT_EQ(kept.patch_index(i), fresh.patch_index(i)) << call << ", " << i;
      ++(shares[i] < 1.0 ? joined : apart);
    }
  }
  EXPECT_GT(joined, 1000u);
  EXPECT_GT(apart, 1000u);
}

}  // namespace
}  // namespace clast
