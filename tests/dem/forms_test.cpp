// Blocks that settle behind forms: fixed frictionless bodies that hold them and nothing else.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "dem/contact/spring_dashpot_law.hpp"
#include "dem/simulation/sequence.hpp"
#include "tests/support/gravity.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

constexpr double kAngle = 0.4;  ///< of the incline, which falls along x
const GroundParameters kSmooth{.energy_restitution = 0.05, .friction = 0.0};
const GroundParameters kRough{.energy_restitution = 0.05, .friction = 0.6, .rolling_friction = 0.1};

TerrainSurface incline(double angle) {
  TriangleMesh mesh = plane_mesh(20.0, 10);
  for (Vec3& vertex : mesh.vertices) vertex.z() = -std::tan(angle) * vertex.x();
  return ground(std::move(mesh));
}

/// Four faces around a square about the origin, 1 m thick; the shape must be `kFaceSides`.
const Vec3 kFaceSides(1.0, 12.0, 12.0);
std::vector<ConfiningWall> square_form(std::size_t shape, double half, std::size_t blocks) {
  std::vector<ConfiningWall> confining_walls;
  for (int side = 0; side < 4; ++side) {
    const double turn = side * kPi / 2.0;
    ConfiningWall form;
    form.shape = shape;
    form.pose.position = -(half + 0.5) * Vec3(std::cos(turn), std::sin(turn), 0.0);
    form.pose.orientation = Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ()));
    form.end = blocks;
    confining_walls.push_back(form);
  }
  return confining_walls;
}

std::vector<std::size_t> add_forms(World& world,
                                   const std::vector<ConfiningWall>& confining_walls) {
  std::vector<std::size_t> numbers;
  for (const ConfiningWall& form : confining_walls) {
    numbers.push_back(world.add_confining_wall(form.shape, form.pose, form.first, form.end));
  }
  return numbers;
}

/// Forces at rest are those of equilibrium at every instant under a law with a dashpot; one that
/// loads and unloads along different lines has them on average.
WorldSettings damped(WorldSettings settings) {
  settings.law = SpringDashpotLaw{};
  return settings;
}

/// Boxes in columns above an incline, turned at random.
std::vector<RigidState> loose_boxes(int per_side, int layers, double apart, double angle,
                                    std::uint64_t seed) {
  std::vector<RigidState> starts;
  Random random(seed);
  for (int k = 0; k < layers; ++k) {
    for (int i = 0; i < per_side; ++i) {
      for (int j = 0; j < per_side; ++j) {
        const double x = apart * (i - 0.5 * (per_side - 1)), y = apart * (j - 0.5 * (per_side - 1));
        RigidState state = at({x, y, 0.6 * apart - std::tan(angle) * x + apart * k});
        const Vec3 axis(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
        state.orientation = Quat(Eigen::AngleAxisd(kPi * random.uniform(), axis.normalized()));
        starts.push_back(state);
      }
    }
  }
  return starts;
}

// On a frictionless incline the ground carries N along its normal: N cos = m g and N sin is what an
// upright frictionless face carries, m g tan.
TEST(Form, CarriesTheSlopingWeightOfACube) {
  const TerrainSurface terrain = incline(kAngle);
  const double side = 0.5, mass = 300.0;
  const std::vector<RigidBody> shapes = {box(mass, Vec3::Constant(side)), box(1e3, kFaceSides)};
  World world(shapes, damped(automatic_world({shapes[0]}, kSmooth, 3.0)), terrain, {kSmooth});
  RigidState start = at({0.0, 0.0, 0.5 * side / std::cos(kAngle) + 1e-3});
  start.orientation = Quat(Eigen::AngleAxisd(kAngle, Vec3::UnitY()));
  world.add_body(0, start);
  ConfiningWall face = square_form(1, 0.6, 1)[2];  // the one that the cube slides onto
  const std::size_t form = world.add_confining_wall(1, face.pose, 0, 1);
  ASSERT_EQ(world.run_until_rest(30.0), StopReason::kRest);
  const Vec3 force = world.contact_force(form);
  const double expected = mass * kTestGravity * std::tan(kAngle);
  EXPECT_NEAR(force.x(), expected, 1e-3 * expected);
  EXPECT_NEAR(force.y(), 0.0, 1e-3 * expected);
  EXPECT_NEAR(force.z(), 0.0, 1e-9 * expected);
}

// The same of a whole heap, whatever its blocks do to each other.
TEST(Form, CarriesTheSlopingWeightOfAHeap) {
  for (const double angle : {0.0, kAngle}) {
    const TerrainSurface terrain = incline(angle);
    const double mass = 60.0;
    const std::vector<RigidBody> shapes = {box(mass, {0.4, 0.3, 0.25}, 0.03), box(1e3, kFaceSides)};
    World world(shapes, damped(automatic_world({shapes[0]}, kRough, 6.0)), terrain, {kSmooth});
    const std::vector<RigidState> starts = loose_boxes(3, 3, 0.65, angle, 11);
    for (const RigidState& start : starts) world.add_body(0, start);
    const auto confining_walls = add_forms(world, square_form(1, 1.0, starts.size()));
    ASSERT_EQ(world.run_until_rest(60.0), StopReason::kRest) << angle;
    const double weight = mass * kTestGravity * static_cast<double>(starts.size());
    std::vector<Vec3> forces;
    for (const std::size_t form : confining_walls) forces.push_back(world.contact_force(form));
    const Vec3 sum = forces[0] + forces[1] + forces[2] + forces[3];
    EXPECT_NEAR(sum.x(), weight * std::tan(angle), 5e-3 * weight);
    EXPECT_NEAR(sum.y(), 0.0, 5e-3 * weight);
    EXPECT_NEAR(sum.z(), 0.0, 1e-9 * weight);
    for (int i = 0; i < 4; ++i) {
      // Each is pushed outwards alone, and the heap does press on it.
      const double outwards =
          forces[i].dot(Vec3(-std::cos(i * kPi / 2), -std::sin(i * kPi / 2), 0));
      EXPECT_NEAR(forces[i].norm(), outwards, 1e-9 * weight);
      if (angle == 0.0) {
        EXPECT_GT(outwards, 5e-3 * weight);
      }
    }
    EXPECT_LT(world.energy_balance().error, 1e-3);
  }
}

TEST(Form, TouchesNothingButWhatItHolds) {
  const TerrainSurface terrain = incline(0.0);
  const std::vector<RigidBody> shapes = {ball(50.0, 0.2), box(1e3, kFaceSides)};
  World world(shapes, automatic_world({shapes[0]}, kRough, 6.0), terrain, {kRough});
  world.add_body(0, at({-0.5, 0.0, 0.21}, {2.0, 0.0, 0.0}));
  world.add_body(0, at({-0.5, 1.0, 0.21}, {2.0, 0.0, 0.0}));
  world.add_confining_wall(1, square_form(1, 0.0, 0)[2].pose, 1, 2);  // face at x = 0
  world.run_until_rest(0.5);
  EXPECT_GT(world.state(0).position.x(), 0.0);
  EXPECT_LT(world.state(1).position.x(), -0.19);
}

TEST(Form, LetsWhatRestsOnItGoWhenItIsRemoved) {
  const TerrainSurface terrain = incline(kAngle);
  const std::vector<RigidBody> shapes = {box(300.0, Vec3::Constant(0.5)), box(1e3, kFaceSides)};
  World world(shapes, automatic_world({shapes[0]}, kSmooth, 3.0), terrain, {kSmooth});
  RigidState start = at({0.0, 0.0, 0.25 / std::cos(kAngle) + 1e-3});
  start.orientation = Quat(Eigen::AngleAxisd(kAngle, Vec3::UnitY()));
  world.add_body(0, start);
  const std::size_t form = world.add_confining_wall(1, square_form(1, 0.6, 1)[2].pose, 0, 1);
  ASSERT_EQ(world.run_until_rest(30.0), StopReason::kRest);
  const double before = world.state(0).position.x(), time = world.time();
  world.remove_body(form);
  EXPECT_FALSE(world.is_resting(0));
  world.run_to_time(time + 1.0);
  // Free of friction it slides g sin t^2/2 along the incline.
  EXPECT_NEAR((world.state(0).position.x() - before) / std::cos(kAngle),
              0.5 * kTestGravity * std::sin(kAngle), 0.03);
  EXPECT_LT(world.energy_balance().error, 1e-3);
}

class SettledSequence : public testing::Test {
 protected:
  SettledSequence() {
    settings_.world = automatic_world({shapes_[0]}, kRough, 6.0);
    settings_.at_once = true;
    settings_.max_time = 30.0;
    settings_.settle_time = 60.0;
    for (const RigidState& start : loose_boxes(2, 3, 0.65, 0.0, 5)) blocks_.push_back({0, start});
    settings_.confining_walls = square_form(1, 0.7, blocks_.size());
  }
  std::vector<SequenceResult> release(const SequenceObserver& observe = {}) const {
    return simulate_sequence(terrain_, std::vector{kRough}, shapes_, blocks_, settings_, {observe});
  }
  const TerrainSurface terrain_ = incline(0.0);
  const std::vector<RigidBody> shapes_ = {box(60.0, {0.4, 0.3, 0.25}, 0.03), box(1e3, kFaceSides)};
  std::vector<SequenceBlock> blocks_;
  SequenceSettings settings_;
};

TEST_F(SettledSequence, IsEndedByItsObserverAlsoWhileItSettles) {
  struct Enough {};
  std::size_t steps = 0;
  const auto end = [&](const SequenceProgress& now) {
    EXPECT_TRUE(now.settling);
    EXPECT_EQ(now.released, blocks_.size());
    if (++steps == 10) throw Enough();
  };
  EXPECT_THROW(simulate_sequence(terrain_, std::vector{kRough}, shapes_, blocks_, settings_,
                                 {.progress = end}),
               Enough);
  EXPECT_EQ(steps, 10u);
}

TEST_F(SettledSequence, BeginsWhenTheBlocksRest) {
  double first = -1.0;
  const auto found = release([&](std::size_t, const MotionStep& step) {
    if (first < 0.0) first = step.begin_time;
  });
  EXPECT_NEAR(first, 0.0, 1e-9);
  double moved = 0.0, potential = 0.0, loose = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_TRUE(found[i].state_after_settling);
    EXPECT_LT(found[i].state_after_settling->position.z(), blocks_[i].start.position.z());
    EXPECT_LT(found[i].state_after_settling->position.head<2>().cwiseAbs().maxCoeff(), 0.7);
    EXPECT_LT(found[i].state_after_settling->velocity.norm(), 0.03);
    EXPECT_EQ(found[i].released_at, 0.0);
    EXPECT_EQ(found[i].release.stop_reason, StopReason::kRest);
    EXPECT_LT(found[i].release.energy.error, 1e-3);
    EXPECT_LT(found[i].blocks_hit, found.size());
    moved +=
        (found[i].release.final_state.position - found[i].state_after_settling->position).norm();
    potential += 60.0 * kTestGravity * found[i].state_after_settling->position.z();
    loose += 60.0 * kTestGravity * blocks_[i].start.position.z();
  }
  EXPECT_GT(moved, 0.2);
  // The balance counts from then on, with what the springs of the contacts hold.
  EXPECT_GT(found[0].release.energy.initial, potential);
  EXPECT_LT(found[0].release.energy.initial, potential + 0.1 * (loose - potential));
  SequenceSettings& settings = settings_;
  settings.world.threads = 2;
  const auto threads = release();
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(threads[i].state_after_settling->position, found[i].state_after_settling->position);
    EXPECT_EQ(threads[i].release.final_state.position, found[i].release.final_state.position);
  }
}

TEST_F(SettledSequence, HoldsOthersUntilTheirTimeAndRemovesFacesOneByOne) {
  blocks_.push_back({0, at({4.0, 0.0, 1.0}), 1.5});
  blocks_.push_back({0, at({-4.0, 0.0, 1.0})});
  for (std::size_t i = 0; i < 4; ++i)
    settings_.confining_walls[i].removed_at = 2.0 + static_cast<double>(i);
  std::vector<double> seen(blocks_.size(), -1.0);
  const auto found = release([&](std::size_t block, const MotionStep& step) {
    if (seen[block] < 0.0) seen[block] = step.begin_time;
  });
  EXPECT_EQ(found[0].released_at, 2.0);
  EXPECT_EQ(found[12].released_at, 1.5);
  EXPECT_EQ(found[13].released_at, 0.0);
  EXPECT_FALSE(found[12].state_after_settling || found[13].state_after_settling);
  EXPECT_NEAR(seen[12], 1.5, 1e-9);
  EXPECT_NEAR(seen[13], 0.0, 1e-9);
  EXPECT_GT(found[0].release.duration, 5.0);
  double west = 0.0;
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(found[i].release.stop_reason, StopReason::kRest);
    EXPECT_LT(found[i].release.energy.error, 1e-3);
    west = std::min(west, found[i].release.final_state.position.x());
  }
  EXPECT_LT(west, -0.45);  // out of the face that was removed first
}

TEST_F(SettledSequence, RefusesWhatDoesNotSettle) {
  settings_.settle_time = 0.2;
  EXPECT_TRUE(
      contains(refusal<SimulationError>([&] { release(); }), " of 12 blocks that settle, body "));
  EXPECT_TRUE(contains(refusal<SimulationError>([&] { release(); }),
                       "still move after settle_time = 0.2 s; give them more time"));
  settings_.settle_time = 0.0;
  EXPECT_TRUE(contains(refusal([&] { release(); }), "settle_time = 0; must be above 0"));
  settings_.settle_time = 60.0;
  blocks_.back().start.position.x() = 2.0;
  EXPECT_TRUE(
      contains(refusal<SimulationError>([&] { release(); }),
               "1 of 12 blocks that settle, body 11 the first, left their confining walls"));
  settings_.at_once = false;
  EXPECT_TRUE(contains(refusal([&] { release(); }), "also give at_once"));
}

}  // namespace
}  // namespace clast
