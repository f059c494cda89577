// Scenes of several bodies: what must hold whatever they do.
#include <gtest/gtest.h>

#include <cmath>

#include "dem/contact/stiffness.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

/// Rocks, boxes, balls and rods of all sizes, two of which are launched at each other.
std::vector<RigidBody> zoo() {
  return {ball(1.0, 0.1),
          capsule(1.5, 0.3, 0.06),
          box(2.0, {0.3, 0.2, 0.25}, 0.02),
          box(3.0, {0.35, 0.2, 0.15}, 0.0, 2),
          rock(3, {0.2, 0.15, 0.12}, 0.01, 100.0, 3),
          rock(4, {0.16, 0.17, 0.12}, 0.0, 300.0, 5)};
}

struct Launch {
  std::size_t shapes[2];
  RigidState states[2];
};

Launch random_launch(std::uint64_t seed) {
  Random random(seed);
  Launch launch;
  const Vec3 line = random.unit_vector();
  for (const int i : {0, 1}) {
    launch.shapes[i] = random.uniform_index(6);
    RigidState& state = launch.states[i];
    state.orientation = random.rotation();
    state.position = (i == 0 ? 0.25 : -0.25) * line + 0.03 * random.unit_vector();
    state.velocity = (i == 0 ? -2.0 : 2.0) * line + 0.3 * random.unit_vector();
    state.angular_velocity = 4.0 * random.unit_vector();
  }
  return launch;
}

class Collisions : public testing::TestWithParam<ContactWeighting> {};

TEST_P(Collisions, KeepMomentumAndAccountForEnergy) {
  const std::vector<RigidBody> shapes = zoo();
  int touched = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Launch launch = random_launch(seed);
    WorldSettings settings = stiff_world(shapes[0], 1e6, 40.0);
    settings.weighting = GetParam();
    settings.between_bodies = {0.1, 0.6, 0.3};
    World world(shapes, settings);
    double linear = 0.0;
    for (const int i : {0, 1}) {
      world.add_body(launch.shapes[i], launch.states[i]);
      linear += shapes[launch.shapes[i]].mass * launch.states[i].velocity.norm();
    }
    const Vec3 momentum = world.linear_momentum(), spin = world.angular_momentum();
    bool apart = true;
    while (world.time() < 0.15) {
      world.step();
      apart = apart && world.statistics().touching_pairs == 0;
      ASSERT_LT((world.linear_momentum() - momentum).norm(), 1e-12 * linear) << seed;
      ASSERT_LT((world.angular_momentum() - spin).norm(), 1e-12 * linear) << seed;
    }
    if (apart) continue;
    ++touched;
    EXPECT_LT(world.energy_balance().error, 0.005) << seed;
  }
  EXPECT_GT(touched, 40);
}
INSTANTIATE_TEST_SUITE_P(Weights, Collisions,
                         testing::Values(ContactWeighting::kPatch, ContactWeighting::kOverlap,
                                         ContactWeighting::kCount, ContactWeighting::kNone),
                         [](const auto& test) { return name_of(test.param); });

// Which of two bodies is the reference body follows from their shapes, not from their order.
TEST(Order, OfBodiesChangesNothing) {
  const std::vector<RigidBody> shapes = zoo();
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Launch launch = random_launch(seed);
    if (launch.shapes[0] == launch.shapes[1]) continue;
    WorldSettings settings = stiff_world(shapes[0], 1e6, 40.0);
    settings.between_bodies = {0.1, 0.6, 0.3};
    World world(shapes, settings), swapped(shapes, settings);
    for (const int i : {0, 1}) {
      world.add_body(launch.shapes[i], launch.states[i]);
      swapped.add_body(launch.shapes[1 - i], launch.states[1 - i]);
    }
    world.run_until_rest(0.15);
    swapped.run_until_rest(0.15);
    for (const std::size_t i : {0u, 1u}) {
      EXPECT_LT((world.state(i).position - swapped.state(1 - i).position).norm(), 1e-12) << seed;
      EXPECT_LT((world.state(i).velocity - swapped.state(1 - i).velocity).norm(), 1e-10) << seed;
    }
  }
}

/// Three rocks dropped onto each other.
World small_pile(const TerrainSurface& terrain, unsigned threads = 1) {
  std::vector<RigidBody> shapes = {rock(3, {0.5, 0.42, 0.3}, 0.02, 2650.0, 4),
                                   box(250.0, {0.5, 0.45, 0.35}, 0.02)};
  const std::vector<GroundParameters> zones = {{0.05, 0.7, 0.3}};
  WorldSettings settings;
  settings.stiffness = choose_stiffness(shapes, zones, 5.0, 9.81).stiffness;
  settings.between_bodies = zones[0];
  settings.threads = threads;
  World world(shapes, settings, terrain, zones);
  RigidState state = at({0.0, 0.0, 0.6});
  world.add_body(0, state);
  state = at({0.08, 0.05, 1.4});
  state.orientation = Quat(Eigen::AngleAxisd(0.2, Vec3(1, 2, 0.5).normalized()));
  world.add_body(1, state);
  state = at({-0.05, 0.1, 2.2});
  state.orientation = Quat(Eigen::AngleAxisd(0.4, Vec3(0, 1, 0.5).normalized()));
  world.add_body(0, state);
  return world;
}

TEST(Pile, OfThreeComesToRestAndDoesNotCreep) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  World world = small_pile(terrain);
  EXPECT_EQ(world.run_until_rest(30.0), StopReason::kRest);
  EXPECT_LT(world.energy_balance().error, 0.005);
  double lowest = 1e300, highest = 0.0;
  std::vector<RigidState> rested;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(world.is_resting(i));
    rested.push_back(world.state(i));
    lowest = std::min(lowest, world.state(i).position.z());
    highest = std::max(highest, world.state(i).position.z());
  }
  const double until = world.time() + 5.0;
  while (world.time() < until) world.step();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 moved = world.state(i).position - rested[i].position;
    EXPECT_LT(moved.head<2>().norm(), 2e-3) << i;
    EXPECT_LT(world.state(i).orientation.angularDistance(rested[i].orientation), 5e-3) << i;
    EXPECT_TRUE(world.is_resting(i));
  }
  EXPECT_LT(world.energy_balance().error, 0.005);
}

/// Rocks, boxes and balls in a heap over a rough slope.
struct FallingHeap {
  std::vector<RigidBody> shapes = {rock(2, {0.25, 0.2, 0.15}, 0.01, 2650.0, 4),
                                   box(30.0, {0.25, 0.2, 0.2}, 0.01), ball(20.0, 0.12)};
  std::vector<GroundParameters> zones = {{0.05, 0.7, 0.3}};
  WorldSettings settings;

  explicit FallingHeap(unsigned threads) {
    settings.stiffness = choose_stiffness(shapes, zones, 8.0, 9.81).stiffness;
    settings.between_bodies = {0.1, 0.5, 0.2};
    settings.threads = threads;
  }
  World world(const TerrainSurface& terrain) const {
    World world(shapes, settings, terrain, zones);
    Random random(7);
    for (std::size_t i = 0; i < 36; ++i) {
      RigidState state = at({0.5 * static_cast<double>(i % 3), 0.5 * static_cast<double>(i / 3 % 3),
                             0.8 + 0.55 * static_cast<double>(i / 9)});
      state.orientation = random.rotation();
      state.velocity = random.unit_vector();
      world.add_body(i % 3, state);
    }
    return world;
  }
};

// Pairs sleep while their bodies cannot have come together. Whoever looks anew at the same places
// finds no contact that they miss, but for what the end of a step still shifts.
TEST(SleepingPairs, MissNoContact) {
  const TerrainSurface terrain = ground(rough_slope(20, 0.5, 0.2, 0.05));
  const FallingHeap heap(1);
  World world = heap.world(terrain);
  WorldSettings any_start = heap.settings;
  any_start.start_overlap = 1e300;
  std::size_t touching = 0;
  for (int look = 0; look < 30; ++look) {
    world.run_until_rest(0.1 * (look + 1));
    World anew(heap.shapes, any_start, terrain, heap.zones);
    for (std::size_t i = 0; i < world.body_count(); ++i) anew.add_body(i % 3, world.state(i));
    anew.run_until_rest(1e-9);
    for (std::size_t i = 0; i < world.body_count(); ++i) {
      EXPECT_NEAR(world.contact_summary(i).overlap, anew.contact_summary(i).overlap, 2e-5)
          << look << ", " << i;
      for (std::size_t other = 0; other < i; ++other) {
        const double overlap = anew.overlap(i, other);
        EXPECT_NEAR(world.overlap(i, other), overlap, 2e-5) << look << ", " << i << ", " << other;
        if (overlap > 0.0) ++touching;
      }
    }
  }
  EXPECT_GT(touching, 200u);
}

class Threads : public testing::TestWithParam<unsigned> {};

TEST_P(Threads, ChangeNoBit) {
  const TerrainSurface terrain = ground(rough_slope(20, 0.5, 0.2, 0.05));
  const auto run = [&](unsigned threads) {
    World world = FallingHeap(threads).world(terrain);
    world.run_until_rest(0.7);
    EXPECT_GT(world.statistics().pair_steps, 1000u);
    return world;
  };
  const World once = run(1), again = run(GetParam());
  for (std::size_t i = 0; i < once.body_count(); ++i) {
    EXPECT_EQ(once.state(i).position, again.state(i).position);
    EXPECT_EQ(once.state(i).orientation.coeffs(), again.state(i).orientation.coeffs());
    EXPECT_EQ(once.state(i).velocity, again.state(i).velocity);
    EXPECT_EQ(once.state(i).angular_velocity, again.state(i).angular_velocity);
  }
  EXPECT_EQ(once.energy_balance().final, again.energy_balance().final);
  EXPECT_EQ(once.energy_balance().dissipated(), again.energy_balance().dissipated());
  EXPECT_LT(once.energy_balance().error, 0.005);
}
INSTANTIATE_TEST_SUITE_P(Counts, Threads, testing::Values(1u, 2u, 5u));

// The same contacts as a release in steps of a given length: only the flights differ, which a
// release does not step.
TEST(OneBody, FallsAsAReleaseDoes) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 9, 0.2));
  const RigidBody body = rock(3, {0.5, 0.42, 0.3}, 0.02, 2650.0, 4);
  const std::vector<GroundParameters> zones = {{0.05, 0.7, 0.3}};
  RigidState start = at({-1.0, 0.3, 1.2}, {0.5, 0.0, 0.0});
  start.orientation = Random(3).rotation();
  start.angular_velocity = {0.5, 1.0, 0.0};
  for (const double shortening : {4.0, 16.0}) {
    ReleaseSettings release;
    release.stiffness = choose_stiffness(std::span(&body, 1), zones, 5.0, 9.81).stiffness;
    release.stiffness.time_step /= shortening;
    release.stiffness.max_time_step = 0.0;
    release.max_time = 0.6;
    WorldSettings settings;
    settings.stiffness = release.stiffness;
    World world({body}, settings, terrain, zones);
    world.add_body(0, start);
    EXPECT_EQ(world.run_until_rest(release.max_time), StopReason::kMaxTime);
    const ReleaseResult result = simulate_release(terrain, zones, body, start, release);
    EXPECT_GT(result.impacts, 0u);
    EXPECT_LT((world.state(0).position - result.final_state.position).norm(), 1e-4);
    EXPECT_LT(world.energy_balance().error, 0.005);
    EXPECT_NEAR(world.energy_balance().dissipated(), result.energy.dissipated(),
                0.01 * result.energy.dissipated());
  }
}

TEST(LeavingTheTerrain, EndsTheRunOfABodyAlone) {
  const TerrainSurface terrain = ground(plane_mesh(2.0, 4));
  const RigidBody body = ball(10.0, 0.2);
  WorldSettings settings = stiff_world(body, 1e6);
  settings.gravity = 9.81;
  World world({body}, settings, terrain, {{0.2, 0.5, 0.3}});
  world.add_body(0, at({1.0, 0, 0.3}, {6.0, 0, 0}));
  world.add_body(0, at({-1.0, 0, 0.3}));
  EXPECT_EQ(world.run_until_rest(20.0), StopReason::kRest);
  EXPECT_TRUE(world.has_left_terrain(0));
  EXPECT_FALSE(world.has_left_terrain(1));
  EXPECT_NEAR(world.state(0).position.x(), 2.0, 0.01);
  EXPECT_LT(world.energy_balance().error, 0.005);
}

TEST(LeavingTheTerrain, LetsOthersFlyOn) {
  const TerrainSurface terrain = ground(plane_mesh(2.0, 4));
  const RigidBody body = ball(10.0, 0.2);
  WorldSettings settings = stiff_world(body, 1e6);
  settings.stiffness.max_time_step = 2.0 * settings.stiffness.time_step;
  settings.gravity = 9.81;
  World world({body}, settings, terrain, {{0.2, 0.5, 0.3}});
  world.add_body(0, at({1.0, 0, 20.0}, {6.0, 0, 0}));
  world.add_body(0, at({1.0, 1.0, 20.0}, {1.0, 0, 0}));
  EXPECT_EQ(world.run_until_rest(20.0), StopReason::kLeftTerrain);
  EXPECT_NEAR(world.state(0).position.x(), 2.0, 0.01);
  EXPECT_NEAR(world.state(1).position.x(), 2.0, 0.01);
  EXPECT_NEAR(world.state(1).velocity.z(), -9.81, 0.1);
}

TEST(Newcomers, BringTheirEnergy) {
  const RigidBody body = ball(10.0, 0.2);
  WorldSettings settings = stiff_world(body, 1e6);
  settings.gravity = 9.81;
  const TerrainSurface terrain = ground(plane_mesh(2.0, 4));
  World world({body}, settings, terrain, {{0.2, 0.5, 0.3}});
  world.add_body(0, at({0, 0, 0.5}));
  world.run_until_rest(1.0);
  const Vec3 force = world.contact_force(0);
  const double before = world.energy_balance().initial;
  world.add_body(0, at({0.5, 0, 1.0}, {0, 1.0, 0}));
  EXPECT_NEAR(world.energy_balance().initial - before, 10.0 * (9.81 + 0.5), 1e-9);
  world.run_until_rest(world.time() + 1e-9);
  EXPECT_LT((world.contact_force(0) - force).norm(), 1e-3 * force.norm());
  world.run_until_rest(3.0);
  EXPECT_LT(world.energy_balance().error, 0.005);
}

TEST(Refusals, SayWhichBodyAndWhy) {
  const std::vector<RigidBody> shapes = {ball(1.0, 0.1)};
  const WorldSettings good = stiff_world(shapes[0], 1e6);
  WorldSettings bad = good;
  bad.between_bodies.energy_restitution = 0.0;
  EXPECT_TRUE(contains(refusal([&] { World(shapes, bad); }), "between bodies"));
  bad = good;
  bad.stiffness.time_step = 0.0;
  EXPECT_TRUE(contains(refusal([&] { World(shapes, bad); }), "time step"));
  bad = good;
  bad.start_overlap = -1.0;
  EXPECT_TRUE(contains(refusal([&] { World(shapes, bad); }), "start_overlap"));
  std::vector<RigidBody> massless = {ball(1.0, 0.1), ball(0.0, 0.1)};
  EXPECT_TRUE(contains(refusal<SimulationError>([&] { World(massless, good); }), "shape 1"));
  const TerrainSurface terrain = ground(plane_mesh(2.0, 4));
  EXPECT_TRUE(
      contains(refusal<SimulationError>([&] { World(shapes, good, terrain, {}); }), "zones"));

  World world(shapes, good, terrain, {{0.2, 0.5, 0.0}});
  const auto adding = [&](std::size_t shape, const RigidState& state) {
    return refusal<SimulationError>([&] { world.add_body(shape, state); });
  };
  EXPECT_TRUE(contains(adding(1, at({0, 0, 1})), "body 0 has shape 1"));
  EXPECT_TRUE(contains(adding(0, at({0, 0, NAN})), "finite"));
  EXPECT_TRUE(contains(adding(0, at({5, 0, 1})), "not on the terrain"));
  EXPECT_TRUE(contains(adding(0, at({0, 0, -1})), "below the ground"));
  RigidState stretched = at({0, 0, 1});
  stretched.orientation.coeffs() *= 1.1;
  EXPECT_TRUE(contains(adding(0, stretched), "unit quaternion"));
  world.add_body(0, at({0, 0, 1}));
  world.add_body(0, at({0.15, 0, 1}));
  EXPECT_TRUE(contains(refusal<SimulationError>([&] { world.step(); }), "body 1 starts inside"));
}

TEST(Blowup, IsNamedWithItsBody) {
  const std::vector<RigidBody> shapes = {ball(1.0, 0.1)};
  WorldSettings settings = stiff_world(shapes[0], 1e6);
  settings.stiffness.time_step = 1e150;
  World world(shapes, settings);
  world.add_body(0, at({0, 0, 0}, {1e200, 0, 0}));
  EXPECT_TRUE(contains(refusal<SimulationError>([&] { world.step(); }), "body 0"));
}

}  // namespace
}  // namespace clast
