// Blocks that fall into clefts narrower or little wider than they are: between two walls they come
// to rest, and what changes of contacts dissipate or add stays small.
#include <gtest/gtest.h>

#include "dem/contact/stiffness.hpp"
#include "dem/simulation/release.hpp"
#include "tests/support/ground_gap.hpp"
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
void PrintTo(const Cleft& cleft, std::ostream* out) { *out << cleft.name; }

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

/// A cube of 0.4 m with a spike of 0.5 m on every face.
RigidBody spiked() {
  constexpr double kHalf = 0.2, kTip = 0.7;
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? kHalf : -kHalf, (i & 2) != 0 ? kHalf : -kHalf,
                               (i & 4) != 0 ? kHalf : -kHalf);
  }
  for (int axis = 0; axis < 3; ++axis) {
    mesh.vertices.emplace_back(-kTip * Vec3::Unit(axis));
    mesh.vertices.emplace_back(kTip * Vec3::Unit(axis));
  }
  const std::array<std::array<std::uint32_t, 4>, 6> squares = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (std::uint32_t f = 0; f < 6; ++f) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      mesh.triangles.push_back({squares[f][k], squares[f][(k + 1) % 4], 8 + f});
    }
  }
  RigidBody body;
  body.shape = make_sphero_polyhedron(mesh, 0.005);
  body.mass = 628.0;
  body.moments = Vec3::Constant(21.0);  // equal by symmetry
  body.smallest_side = 0.8;
  return body;
}

// Behind the edge of a spike is air again. Edges of a thin ridge that get there have passed the
// block, they are not inside it.
TEST(Spikes, EdgesThatPassEachOtherInTheAirDoNotTouch) {
  TriangleMesh mesh;
  for (const double y : {-20.0, 20.0}) {
    for (const auto& [x, z] :
         {std::pair{-20.0, -10.0}, {-1.0, -10.0}, {0.0, 0.0}, {1.0, -10.0}, {20.0, -10.0}}) {
      mesh.vertices.emplace_back(x, y, z);
    }
  }
  for (std::uint32_t a = 0; a < 4; ++a) {
    mesh.triangles.push_back({a, a + 1, a + 6});
    mesh.triangles.push_back({a, a + 6, a + 5});
  }
  const TerrainSurface terrain = ground(std::move(mesh));
  const std::vector<GroundParameters> zones = {{0.01, 0.6, 0.2}};
  const RigidBody body = spiked();
  ReleaseSettings settings;
  settings.stiffness = choose_stiffness(std::span(&body, 1), zones, 20.0, 9.81).stiffness;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    Random random(seed);
    RigidState start;
    start.orientation = random.rotation();
    start.position = {random.uniform(-0.3, 0.3), 0.0, 1.5};
    start.angular_velocity = random.uniform(0.0, 5.0) * random.unit_vector();
    const ReleaseResult result = simulate_release(terrain, zones, body, start, settings);
    EXPECT_EQ(result.stop_reason, StopReason::kRest) << seed;
    EXPECT_LT(std::abs(result.energy.reassigned), 0.05 * result.energy.dissipated()) << seed;
  }
}

// In a pit the walls come near from all sides: a face that a corner is over says nothing of the
// others, and none may be passed unseen.
TEST(Needles, FeelEveryWallOfAPit) {
  constexpr std::uint32_t kSides = 5;
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0.0, 0.0, -10.0);
  for (const double ring : {2.0, 25.0}) {
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const double angle = 2.0 * kPi * k / kSides;
      mesh.vertices.emplace_back(ring * std::cos(angle), ring * std::sin(angle), 0.0);
    }
  }
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const std::uint32_t a = 1 + k, b = 1 + (k + 1) % kSides;
    mesh.triangles.push_back({0, a, b});
    mesh.triangles.push_back({a, a + kSides, b});
    mesh.triangles.push_back({b, a + kSides, b + kSides});
  }
  const TerrainSurface terrain = ground(std::move(mesh));
  const std::vector<GroundParameters> zones = {{0.01, 0.6, 0.2}};
  const RigidBody needle = box(53.0, Vec3(2.0, 0.1, 0.1), 0.004);
  ReleaseSettings settings;
  settings.stiffness = choose_stiffness(std::span(&needle, 1), zones, 20.0, 9.81).stiffness;
  for (std::uint64_t seed = 40; seed < 64; ++seed) {
    Random random(seed);
    RigidState start;
    start.orientation = random.rotation();
    start.position = {random.uniform(-0.3, 0.3), 0.0, -8.0};
    while (ground_gap(terrain, needle, start, 1.0).value_or(1.0) < 1e-3) start.position.z() += 0.1;
    start.velocity = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0};
    start.angular_velocity = random.uniform(0.0, 5.0) * random.unit_vector();
    const ReleaseResult result = simulate_release(terrain, zones, needle, start, settings);
    EXPECT_EQ(result.stop_reason, StopReason::kRest) << seed;
    EXPECT_LT(std::abs(result.energy.reassigned), 0.05 * result.energy.dissipated()) << seed;
    EXPECT_LT(result.max_penetration, 0.25 * needle.smallest_side) << seed;
  }
}

}  // namespace
}  // namespace clast
