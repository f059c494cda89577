// A surface is what it is however it is cut into triangles.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "dem/contact/stiffness.hpp"
#include "tests/support/gravity.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {
namespace {

/// The surface with every triangle cut into four, `times` times.
TriangleMesh subdivided(TriangleMesh mesh, int times) {
  for (int i = 0; i < times; ++i) {
    TriangleMesh finer;
    finer.vertices = mesh.vertices;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, fresh] = middles.try_emplace(
          {std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(finer.vertices.size()));
      if (fresh) finer.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
      return it->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.triangles.push_back({a, ab, ca});
      finer.triangles.push_back({ab, b, bc});
      finer.triangles.push_back({ca, bc, c});
      finer.triangles.push_back({ab, bc, ca});
    }
    mesh = std::move(finer);
  }
  return mesh;
}

/// The same plane as a TIN with random nodes, as a grid, and as two triangles.
TerrainSurface plane(int cells, double slope, bool grid = false, const Vec3& shift = Vec3::Zero()) {
  TriangleMesh mesh = plane_mesh(20.0, cells, slope, 3);
  if (grid) {
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const auto i = static_cast<double>(v % (cells + 1)), j = static_cast<double>(v / (cells + 1));
      const double x = -20.0 + 40.0 * i / cells, y = -20.0 + 40.0 * j / cells;
      mesh.vertices[v] = {x, y, -std::tan(slope) * x};
    }
  }
  for (Vec3& vertex : mesh.vertices) vertex += shift;
  return ground(std::move(mesh));
}

struct Path {
  std::vector<double> times;
  std::vector<RigidState> states;
  ReleaseResult result;
};

/// States at regular times until the end or the impact of the given number.
Path path_on(const TerrainSurface& terrain, const GroundParameters& zone, const RigidBody& body,
             const RigidState& start, const ReleaseSettings& settings, int impacts = 1 << 30) {
  Path path;
  double next = 0.0;
  int seen = 0;
  bool flying = true;
  path.result = simulate_release(
      terrain, std::span(&zone, 1), body, start, settings, [&](const MotionStep& step) {
        if (!step.flight && flying) ++seen;
        flying = step.flight;
        while (next <= step.end_time && seen <= impacts) {
          path.times.push_back(next);
          path.states.push_back(interpolate_state(body, step, next, settings.gravity));
          next += 0.01;
        }
      });
  return path;
}

void expect_same(const Path& a, const Path& b, double tolerance) {
  ASSERT_GT(a.states.size(), 10u);
  const std::size_t count = std::min(a.states.size(), b.states.size());
  double position = 0.0, angle = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    position = std::max(position, (a.states[i].position - b.states[i].position).norm());
    angle = std::max(angle, a.states[i].orientation.angularDistance(b.states[i].orientation));
  }
  EXPECT_LT(position, tolerance);
  EXPECT_LT(angle, tolerance);
}

// A frictionless sphere leaves a flat ground straight up wherever it lands.
TEST(GhostEdges, SpheresKeepTheirLine) {
  const RigidBody body = ball(485.0, 0.35);
  ReleaseSettings settings = stiff_settings(body, 1e8);
  settings.max_time = 0.75;
  for (const int cells : {1, 10, 100}) {
    const TerrainSurface terrain = ground(plane_mesh(5.0, cells));
    Random random(11);
    double worst = 0.0;
    for (int i = 0; i < 256; ++i) {
      RigidState start;
      start.position = {random.uniform(-3, 3), random.uniform(-3, 3), 2.35};
      const ReleaseResult result = simulate_release(
          terrain, std::vector<GroundParameters>{{0.1, 0.0, 0.0}}, body, start, settings);
      ASSERT_EQ(result.impacts, 1u);
      worst = std::max(worst, result.final_state.velocity.head<2>().norm());
      EXPECT_EQ(result.final_state.angular_velocity.norm(), 0.0);
    }
    EXPECT_LT(worst, 1e-6 * 6.264) << cells;
  }
}

// Laid down first, so that it slides: a block that rocks doubles any rounding error every tenth of
// a second, on two triangles as well.
TEST(GhostEdges, ConcaveBlockSlidesOnTheSamePathUntilItStops) {
  const RigidBody body = rock(4, {0.6, 0.5, 0.2}, 0.02, 2650.0, 4);
  const GroundParameters zone{0.01, 0.5, 0.0};
  ReleaseSettings settings;
  settings.stiffness =
      choose_stiffness(std::span(&body, 1), std::span(&zone, 1), 5.0, kTestGravity).stiffness;
  RigidState start;
  start.position = {-5.0, 0.3, 0.0};
  start.position.z() = 0.01 - lowest_height(body, start);
  const TerrainSurface simple = plane(1, 0.0), fine = plane(80, 0.0);
  start = path_on(simple, zone, body, start, settings).result.final_state;
  start.velocity = {3.0, 0.7, 0.0};
  start.angular_velocity = Vec3::Zero();
  settings.start_overlap = 1.0;
  const Path on_two = path_on(simple, zone, body, start, settings);
  EXPECT_EQ(on_two.result.stop_reason, StopReason::kRest);
  EXPECT_GT((on_two.result.final_state.position - start.position).norm(), 0.8);
  expect_same(on_two, path_on(fine, zone, body, start, settings), 1e-6);
}

enum class Form { kSphere, kCube, kBlockColour };
void PrintTo(Form form, std::ostream* out) {
  constexpr std::array kNames = {"sphere", "cube", "rock"};
  *out << kNames.at(static_cast<std::size_t>(form));
}
class Plane : public testing::TestWithParam<Form> {};

// Through the first five impacts or 5 s, whichever is sooner.
TEST_P(Plane, IsOnePlaneHoweverItIsMade) {
  const RigidBody body = GetParam() == Form::kSphere ? ball(500.0, 0.35)
                         : GetParam() == Form::kCube ? box(500.0, Vec3::Constant(0.6), 0.01)
                                                     : rock(3, {0.45, 0.33, 0.28}, 0.02, 2650.0, 6);
  const GroundParameters zone{0.09, 0.6, 0.1};
  ReleaseSettings settings;
  settings.stiffness =
      choose_stiffness(std::span(&body, 1), std::span(&zone, 1), 10.0, kTestGravity).stiffness;
  settings.max_time = 5.0;
  for (const double slope : {0.0, 0.35}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Random random(seed);
      RigidState start;
      start.orientation = random.rotation();
      start.position = {-12.0 + random.uniform(0.0, 1.0), random.uniform(-1.0, 1.0),
                        12.0 * std::tan(slope) + 2.0};
      start.velocity = {1.0, 0.3, 0.0};
      start.angular_velocity = 2.0 * random.unit_vector();
      const Path two = path_on(plane(1, slope), zone, body, start, settings, 5);
      expect_same(two, path_on(plane(57, slope), zone, body, start, settings, 5), 1e-6);
      expect_same(two, path_on(plane(40, slope, true), zone, body, start, settings, 5), 1e-6);
      const Vec3 shift(0.37, -0.61, 0.83);
      RigidState moved = start;
      moved.position += shift;
      Path shifted = path_on(plane(57, slope, false, shift), zone, body, moved, settings, 5);
      for (RigidState& state : shifted.states) state.position -= shift;
      expect_same(two, shifted, 1e-6);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Forms, Plane,
                         testing::Values(Form::kSphere, Form::kCube, Form::kBlockColour));

/// Energy kept at the first separation, as a share, and the peak force.
struct Bounce {
  double kept = -1.0;
  double peak = 0.0;
};
Bounce bounce(const TerrainSurface& terrain, const RigidBody& body, const Quat& orientation,
              double energy_restitution = 0.1) {
  ReleaseSettings settings = stiff_settings(body, 1e8, 40.0);
  settings.gravity = 0.0;
  settings.max_time = 0.5;
  RigidState start;
  start.orientation = orientation;
  start.position = {0.137, 0.211, 0.0};
  start.position.z() = 0.01 - lowest_height(body, start);
  start.velocity = {0.0, 0.0, -5.0};
  Bounce result;
  bool touched = false;
  simulate_release(
      terrain, std::vector<GroundParameters>{{energy_restitution, 0.0, 0.0}}, body, start, settings,
      [&](const MotionStep& step) {
        if (result.kept >= 0.0) return;
        touched = touched || !step.flight;
        if (!step.flight) {
          const Vec3 change = step.end.velocity - step.begin.velocity;
          result.peak =
              std::max(result.peak, body.mass * change.norm() / (step.end_time - step.begin_time));
        } else if (touched) {
          result.kept =
              (translational_energy(body, step.begin) + rotational_energy(body, step.begin)) /
              (12.5 * body.mass);
        }
      });
  return result;
}

// Flat, on an edge and on a corner under its centre.
TEST(MeshIndependence, CentralImpactsReturnTheAskedEnergy) {
  const std::vector<Quat> turns = {Quat::Identity(),
                                   Quat(Eigen::AngleAxisd(kPi / 4.0, Vec3::UnitX())),
                                   Quat::FromTwoVectors(Vec3(1, 1, 1), Vec3(0, 0, -1))};
  for (const int cuts : {1, 2, 4, 8}) {
    const RigidBody body = box(1000.0, Vec3::Ones(), 0.02, cuts);
    for (const int cells : {1, 10, 100}) {
      const TerrainSurface terrain = ground(plane_mesh(5.0, cells));
      for (std::size_t i = 0; i < turns.size(); ++i) {
        EXPECT_NEAR(bounce(terrain, body, turns[i]).kept, 0.1, 0.001)
            << cuts << " cuts, " << cells << " cells, attitude " << i;
      }
    }
  }
}

TEST(MeshIndependence, PeakForceOfAFlatFace) {
  const TerrainSurface terrain = ground(plane_mesh(5.0, 1));
  const double once = bounce(terrain, box(1000.0, Vec3::Ones(), 0.0, 1), Quat::Identity()).peak;
  EXPECT_NEAR(once, 5.0 * std::sqrt(1000.0 * 1e8), 0.02 * once);
  for (const int cuts : {2, 4, 8}) {  // 8, 32, 128 triangles
    const double peak =
        bounce(terrain, box(1000.0, Vec3::Ones(), 0.0, cuts), Quat::Identity()).peak;
    EXPECT_NEAR(peak, once, 0.02 * once) << 2 * cuts * cuts << " triangles";
  }
}

TEST(MeshIndependence, AnyAttitudeKeepsTheSameEnergy) {
  const TerrainSurface simple = ground(plane_mesh(5.0, 1)), fine = ground(plane_mesh(5.0, 100));
  const RigidBody cube = box(1000.0, Vec3::Ones(), 0.02, 1);
  const RigidBody cut_cube = box(1000.0, Vec3::Ones(), 0.02, 4);
  const RigidBody stone = rock(4, {0.42, 0.36, 0.30}, 0.02, 2700.0, 3);
  RigidBody cut_stone = stone;
  cut_stone.shape = make_sphero_polyhedron(subdivided(core_mesh(stone.shape), 1), 0.02);
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 64; ++seed) {
    const Quat turn = Random(seed).rotation();
    for (const auto& [body, cut] : {std::pair(&std::as_const(cube), &std::as_const(cut_cube)),
                                    std::pair(&std::as_const(stone), &std::as_const(cut_stone))}) {
      const double expected = bounce(simple, *body, turn).kept;
      ASSERT_GT(expected, 0.0);
      for (const double kept : {bounce(fine, *body, turn).kept, bounce(fine, *cut, turn).kept}) {
        worst = std::max(worst, std::abs(kept / expected - 1.0));
        EXPECT_NEAR(kept, expected, 0.01 * expected)
            << "seed " << seed << (body == &cube ? ", cube" : ", stone");
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

}  // namespace
}  // namespace clast
