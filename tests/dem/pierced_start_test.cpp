// Blocks that start with an edge of the ground through them are refused however deep it is.
#include <gtest/gtest.h>

#include "tests/support/ground_gap.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {
namespace {

/// A wall along y whose crest, at the origin, has level ground behind it and 15 m of air before it.
TerrainSurface cliff() {
  TriangleMesh mesh;
  for (const double y : {-20.0, 20.0}) {
    for (const auto& [x, z] : {std::pair{-20.0, 0.0}, {0.0, 0.0}, {0.0, -15.0}, {20.0, -15.0}}) {
      mesh.vertices.emplace_back(x, y, z);
    }
  }
  for (std::uint32_t a = 0; a < 3; ++a) {
    mesh.triangles.push_back({a, a + 1, a + 5});
    mesh.triangles.push_back({a, a + 5, a + 4});
  }
  return ground(std::move(mesh));
}

class PiercedStart : public testing::TestWithParam<double> {};

// A plate that leans over the crest at 45 degrees, its centre over the air. The crest is `depth`
// behind its lower face, which none of its corners shows.
TEST_P(PiercedStart, IsRefusedWithItsDepth) {
  const double depth = GetParam();
  const TerrainSurface terrain = cliff();
  const RigidBody plate = box(1000.0, Vec3(4.0, 1.0, 0.4));
  RigidState start;
  start.orientation = Quat(Eigen::AngleAxisd(0.25 * kPi, Vec3::UnitY()));
  const Vec3 up = start.orientation * Vec3::UnitZ(), along = start.orientation * Vec3::UnitX();
  start.position = (0.2 - depth) * up + 0.9 * along;
  const std::optional<double> gap = ground_gap(terrain, plate, start, 5.0);
  ASSERT_TRUE(gap);
  EXPECT_LT(*gap, 0.0);
  const std::string message = refusal<SimulationError>([&] {
    simulate_release(terrain, std::vector<GroundParameters>{{0.1, 0.5, 0.0}}, plate, start,
                     stiff_settings(plate, 1e8));
  });
  EXPECT_NE(message.find("starts inside the ground"), std::string::npos) << message;
}
INSTANTIATE_TEST_SUITE_P(Depths, PiercedStart, testing::Values(0.01, 0.1, 0.19, 0.25, 0.35));

}  // namespace
}  // namespace clast
