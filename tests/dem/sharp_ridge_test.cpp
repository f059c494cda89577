// Ridges sharper than a right angle: the air over them lies behind the planes of their faces.
#include <gtest/gtest.h>

#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

constexpr double kHalfWidth = 1.0, kHeight = 10.0, kRidgeRadius = 0.5, kSpeed = 5.0;

/// A ridge along y whose flanks fall by 84 degrees, or the same turned into a lone peak.
TriangleMesh knife(bool peak) {
  TriangleMesh mesh;
  if (peak) {
    mesh.vertices = {{0.0, 0.0, 0.0}};
    for (const double x : {-1.0, 1.0}) mesh.vertices.emplace_back(x * kHalfWidth, -1.0, -kHeight);
    for (const double x : {1.0, -1.0}) mesh.vertices.emplace_back(x * kHalfWidth, 1.0, -kHeight);
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    return mesh;
  }
  for (const double y : {-5.0, 5.0}) {
    mesh.vertices.emplace_back(-kHalfWidth, y, -kHeight);
    mesh.vertices.emplace_back(0.0, y, 0.0);
    mesh.vertices.emplace_back(kHalfWidth, y, -kHeight);
  }
  mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  return mesh;
}

struct Hit {
  const char* name;
  bool peak;
  double offset;  ///< of the centre from the ridge along x, m
};
void PrintTo(const Hit& hit, std::ostream* out) { *out << hit.name; }

class SharpRidge : public testing::TestWithParam<Hit> {};

// Without friction and losses the speed along the line from the ridge to the centre is turned
// round, the rest stays: v - 2 (v.n) n.
TEST_P(SharpRidge, ReflectsABall) {
  const auto [name, peak, offset] = GetParam();
  const TerrainSurface terrain = ground(knife(peak));
  const RigidBody body = ball(1000.0, kRidgeRadius);
  ReleaseSettings settings = stiff_settings(body, 4e9, 100.0);
  settings.gravity = 0.0;
  settings.max_time = 0.1;
  RigidState start;
  const double up = std::sqrt(kRidgeRadius * kRidgeRadius - offset * offset);
  start.position = {offset, 0.0, up + 0.05};
  start.velocity = {0.0, 0.0, -kSpeed};
  const ReleaseResult result = simulate_release(
      terrain, std::vector<GroundParameters>{{1.0, 0.0, 0.0}}, body, start, settings);
  const Vec3 normal = Vec3(offset, 0.0, up) / kRidgeRadius;
  const Vec3 expected = start.velocity - 2.0 * start.velocity.dot(normal) * normal;
  EXPECT_LT((result.final_state.velocity - expected).norm(), 0.01 * kSpeed)
      << result.final_state.velocity.transpose();
  EXPECT_EQ(result.impacts, 1u);
}
INSTANTIATE_TEST_SUITE_P(Offsets, SharpRidge,
                         testing::Values(Hit{"RidgeMiddle", false, 0.0},
                                         Hit{"RidgeLeft", false, -0.2},
                                         Hit{"RidgeRight", false, 0.2}, Hit{"PeakLeft", true, -0.2},
                                         Hit{"PeakRight", true, 0.2}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace clast
