// Surface of a rounded body.
#include "particles/detail/body_surface.hpp"

#include <gtest/gtest.h>

#include "particles/shape_errors.hpp"
#include "tests/library/block_samples.hpp"

namespace clast {
namespace {

using particles_detail::BodySurface;

constexpr double kRadius = 0.2;

/// Prism over an L of two arms of 2 x 1, 1 high, with a reflex edge at x = y = 1.
TriangleMesh angle_prism() {
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const Vec2& p : {Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(1, 1), Vec2(1, 2), Vec2(0, 2)}) {
      mesh.vertices.emplace_back(p.x(), p.y(), z);
    }
  }
  for (std::uint32_t k = 1; k < 5; ++k) {
    mesh.triangles.push_back({0, k + 1, k});
    mesh.triangles.push_back({6, 6 + k, 7 + k});
  }
  for (std::uint32_t k = 0; k < 6; ++k) {
    const std::uint32_t next = (k + 1) % 6;
    mesh.triangles.push_back({k, next, 6 + next});
    mesh.triangles.push_back({k, 6 + next, 6 + k});
  }
  return mesh;
}

double distance_to_box(const Vec3& point, const Vec3& low, const Vec3& high) {
  return (point - point.cwiseMax(low).cwiseMin(high)).norm();
}

TEST(BodySurface, DistancesOfARoundedCuboidAreThoseOfItsFormula) {
  const BodySurface surface(cuboid(2.0, 2.0, 2.0), kRadius);
  EXPECT_NEAR(surface.closest({0.0, 0.0, 1.5}).distance, 0.3, 1e-12);
  EXPECT_NEAR(surface.closest({0.0, 0.0, 0.9}).distance, -0.3, 1e-12);
  EXPECT_NEAR(surface.closest({2.0, 2.0, 2.0}).distance, std::sqrt(3.0) - kRadius, 1e-12);
  EXPECT_NEAR((surface.closest({0.0, 2.0, 2.0}).outward - Vec3(0.0, 1.0, 1.0).normalized()).norm(),
              0.0, 1e-12);
  EXPECT_NEAR((surface.closest({0.1, 0.2, 0.7}).foot({0.1, 0.2, 0.7}) - Vec3(0.1, 0.2, 1.2)).norm(),
              0.0, 1e-12);
}

TEST(BodySurface, SamplesAreAtTheRadiusFromTheSolid) {
  const BodySurface surface(angle_prism(), kRadius);
  const std::vector<Vec3> samples = surface.sample(4000);
  EXPECT_NEAR(static_cast<double>(samples.size()), 4000.0, 80.0);
  EXPECT_EQ(surface.corners(100).size(), 10u) << "those of the reflex edge are inside the body";
  for (const Vec3& point : samples) {
    const double distance = std::min(distance_to_box(point, {0, 0, 0}, {2, 1, 1}),
                                     distance_to_box(point, {0, 0, 0}, {1, 2, 1}));
    ASSERT_GT(distance, (1.0 - 1e-2) * kRadius);
    ASSERT_LT(distance, (1.0 + 1e-2) * kRadius);
  }
}

TEST(BodySurface, AreaOfARoundedCuboidIsThatOfItsFormula) {
  const BodySurface surface(cuboid(3.0, 2.0, 1.0), kRadius);
  EXPECT_NEAR(surface.area(),
              2.0 * (6.0 + 2.0 + 3.0) + 2.0 * kPi * kRadius * 6.0 + 4.0 * kPi * kRadius * kRadius,
              0.1);
}

TEST(BodySurface, ErrorsOfAClumpAreThoseOfTheRoundedBody) {
  ParticleBody body = make_particle_body(cuboid(3.0, 2.0, 1.0));
  body.radius = kRadius;
  // The point of the body that is farthest from the ball is on the rounding of a corner.
  EXPECT_NEAR(measure_clump_errors(body, {{{Vec3::Zero(), 0.5}}}).surface,
              (Vec3(1.5, 1.0, 0.5).norm() + kRadius - 0.5) / 3.0, 1e-4);
}

}  // namespace
}  // namespace clast
