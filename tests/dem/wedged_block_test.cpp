// Blocks that fall into clefts narrower or little wider than they are: held between two walls they
// come to rest, and what changing contacts take or give stays small.
#include <gtest/gtest.h>

#include "dem/stiffness.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

/// Level ground with a cleft along y whose walls run from these half widths at the top to those at
/// the bottom, 5 m deep.
TerrainSurface cleft(double half_top, double half_bottom) {
  std::vector<std::array<double, 2>> profile = {
      {-20.0, 0.0}, {-half_top, 0.0}, {-half_bottom, -5.0}};
  if (half_bottom > 0.0) profile.push_back({half_bottom, -5.0});
  profile.push_back({half_top, 0.0});
  profile.push_back({20.0, 0.0});
  TriangleMesh mesh;
  for (const double y : {-20.0, 20.0}) {
    for (const auto& [x, z] : profile) mesh.vertices.emplace_back(x, y, z);
  }
  const auto count = static_cast<std::uint32_t>(profile.size());
  for (std::uint32_t a = 0; a + 1 < count; ++a) {
    const std::uint32_t b = a + 1, c = a + count, d = c + 1;
    mesh.triangles.push_back({a, b, d});
    mesh.triangles.push_back({a, d, c});
  }
  return ground(std::move(mesh));
}

struct Cleft {
  const char* name;
  double half_top, half_bottom;
};

class Wedged : public testing::TestWithParam<Cleft> {};

TEST_P(Wedged, CubesComeToRest) {
  const TerrainSurface terrain = cleft(GetParam().half_top, GetParam().half_bottom);
  const std::vector<GroundParameters> zones = {{0.1, 0.5, 0.1}};
  const RigidBody cube = box(2650.0, Vec3::Constant(1.0), 0.01);
  ReleaseSettings settings;
  settings.stiffness = choose_stiffness(std::span(&cube, 1), zones, 11.0, 9.81).stiffness;
  for (std::uint64_t attitude = 0; attitude < 16; ++attitude) {
    RigidState start;
    start.orientation = Random(attitude).rotation();
    start.position = {0.0, 0.0, 6.0};
    const ReleaseResult result = simulate_release(terrain, zones, cube, start, settings);
    EXPECT_EQ(result.stop_reason, StopReason::kRest) << attitude;
    EXPECT_LT(result.duration, 20.0) << attitude;
    EXPECT_FALSE(result.below_ground) << attitude;
    EXPECT_LT(std::abs(result.energy.reassigned), 0.1 * result.energy.dissipated()) << attitude;
  }
}
INSTANTIATE_TEST_SUITE_P(Clefts, Wedged,
                         testing::Values(Cleft{"Straight", 0.6, 0.6}, Cleft{"Pointed", 0.4, 0.0},
                                         Cleft{"Narrowing", 0.7, 0.3}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace clast
