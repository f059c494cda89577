// Bodies that rest together cost nothing until something touches one of them.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

const std::vector<GroundParameters> kSleepGround = {{0.05, 0.7, 0.3}};

/// A heap of six rocks and boxes with nothing moving.
World sleeping_heap(const TerrainSurface& terrain, unsigned threads = 1, bool sleeps = true) {
  const std::vector<RigidBody> shapes = {rock(3, {0.5, 0.42, 0.3}, 0.02, 2650.0, 4),
                                         box(250.0, {0.5, 0.45, 0.35}, 0.02), ball(40.0, 0.15)};
  WorldSettings settings = automatic_world(shapes, kSleepGround[0], 8.0);
  settings.threads = threads;
  if (!sleeps) settings.sleep_drift = 0.0;
  World world(shapes, settings, terrain, kSleepGround);
  Random random(11);
  for (std::size_t i = 0; i < 6; ++i) {
    RigidState state = at({0.25 * random.uniform(-1.0, 1.0), 0.25 * random.uniform(-1.0, 1.0),
                           0.6 + 1.2 * static_cast<double>(i)});
    state.orientation = random.rotation();
    world.add_body(i % 2, state);
  }
  const double limit = 40.0;
  while (world.time() < limit) {
    world.step();
    if (sleeps ? world.statistics().sleeping_bodies == 6 : world.time() > 8.0) break;
  }
  return world;
}

TEST(Sleep, TakesAHeapOutOfTheMotionAndKeepsItsPlaces) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  World world = sleeping_heap(terrain);
  ASSERT_EQ(world.statistics().sleeping_bodies, 6u) << "at " << world.time() << " s";
  EXPECT_EQ(world.statistics().active_pairs, 0u);
  EXPECT_GT(world.statistics().touching_pairs, 5u);
  EXPECT_EQ(world.run_until_rest(world.time() + 1.0), StopReason::kRest);
  std::vector<RigidState> asleep;
  for (std::size_t i = 0; i < 6; ++i) asleep.push_back(world.state(i));
  for (int step = 0; step < 2000; ++step) world.step();
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_TRUE(world.is_asleep(i) && world.is_resting(i));
    EXPECT_EQ(world.state(i).position, asleep[i].position);
    EXPECT_EQ(world.state(i).orientation.coeffs(), asleep[i].orientation.coeffs());
  }
  EXPECT_LT(world.energy_balance().error, 0.005);
}

// Blocks at rest go on rocking a little on their tangential springs, and sleep catches them at some
// place of that: the ground carries their weight to within what that takes.
TEST(Sleep, ComesOnlyToWhatRestsWithItsWeightCarried) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const World world = sleeping_heap(terrain);
  double weight = 0.0;
  Vec3 force = Vec3::Zero();
  for (std::size_t i = 0; i < 6; ++i) {
    force += world.contact_force(i);  // forces between bodies cancel
    weight += 9.81 * (i % 2 == 0 ? rock(3, {0.5, 0.42, 0.3}, 0.02, 2650.0, 4).mass : 250.0);
  }
  EXPECT_NEAR(force.z() / weight, 1.0, 0.02);
}

// Balls thrown from everywhere at a sleeping heap: nothing asleep is ever touched by what moves.
TEST(Sleep, EndsWithEveryTouch) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  Random random(5);
  std::size_t hits = 0;
  for (int poke = 0; poke < 12; ++poke) {
    World world = sleeping_heap(terrain);
    ASSERT_EQ(world.statistics().sleeping_bodies, 6u);
    Vec3 direction = random.unit_vector();
    direction.z() = -std::abs(direction.z()) - 0.1;
    direction.normalize();
    const Vec3 target = world.state(random.uniform_index(6)).position;
    const std::size_t ball = world.add_body(2, at(target - 3.0 * direction, 6.0 * direction));
    bool hit = false;
    const double end = world.time() + 1.5;
    while (world.time() < end) {
      world.step();
      for (std::size_t i = 0; i < 6; ++i) {
        if (world.is_asleep(ball) || !(world.overlap(i, ball) > 0.0)) continue;
        hit = true;
        ASSERT_FALSE(world.is_asleep(i)) << "poke " << poke << ", body " << i;
      }
    }
    hits += hit;
    EXPECT_LT(world.energy_balance().error, 0.005) << poke;
  }
  EXPECT_GE(hits, 10u);
}

// A ball thrown at a sleeping box, and at one that never slept: the same blow, in the same steps.
TEST(Sleep, ChangesNoBlow) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {box(250.0, {0.5, 0.45, 0.35}, 0.02), ball(40.0, 0.15)};
  const auto thrown = [&](bool sleeps) {
    WorldSettings settings = automatic_world(shapes, kSleepGround[0], 8.0);
    settings.stiffness.max_time_step = 0.0;
    if (!sleeps) settings.sleep_drift = 0.0;
    World world(shapes, settings, terrain, kSleepGround);
    world.add_body(0, at({0.0, 0.0, 0.25}));
    while (world.time() < 4.0) world.step();
    EXPECT_EQ(world.is_asleep(0), sleeps);
    const Vec3 target = world.state(0).position;
    const Vec3 direction = Vec3(0.9, 0.1, -0.1).normalized();
    world.add_body(1, at(target - direction, 8.0 * direction));
    const double dissipated = world.energy_balance().dissipated();
    while (world.time() < 4.4) world.step();
    EXPECT_FALSE(world.is_asleep(0));
    return std::pair(Vec3(world.state(0).position - target),
                     world.energy_balance().dissipated() - dissipated);
  };
  const auto [moved, lost] = thrown(true);
  const auto [moved_awake, lost_awake] = thrown(false);
  EXPECT_GT(moved_awake.norm(), 0.05);
  EXPECT_LT((moved - moved_awake).norm(), 1e-3 * moved_awake.norm());
  EXPECT_NEAR(lost / lost_awake, 1.0, 1e-4);
}

TEST(Sleep, HasTheSameBitsOnAnyNumberOfThreads) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const auto run = [&](unsigned threads) {
    World world = sleeping_heap(terrain, threads);
    world.add_body(2, at(world.state(0).position + Vec3(0.02, 0.05, 3.0)));
    world.run_until_rest(world.time() + 1.0);
    return world;
  };
  const World one = run(1), three = run(3);
  EXPECT_EQ(one.time(), three.time());
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(one.state(i).position, three.state(i).position);
    EXPECT_EQ(one.state(i).velocity, three.state(i).velocity);
  }
  EXPECT_EQ(one.energy_balance().dissipated(), three.energy_balance().dissipated());
}

// Slow enough to count as resting, but not in one place.
TEST(Sleep, DoesNotComeToWhatSlides) {
  const RigidBody body = box(100.0, {0.5, 0.5, 0.2}, 0.02);
  WorldSettings settings = automatic_world({body}, kSleepGround[0], 3.0);
  settings.rest_energy = 1e3;  // slow enough always
  settings.rest_duration = 1e3;
  const double slope = std::atan(0.5);
  TriangleMesh mesh = plane_mesh(40.0, 8);
  for (Vec3& vertex : mesh.vertices) vertex.z() = -0.5 * vertex.x();
  const TerrainSurface terrain = ground(mesh);
  World world({body}, settings, terrain, {{0.05, 0.3, 0.0}});  // slides: mu below tan(slope)
  RigidState state =
      at(Vec3(-20.0, 0.0, 10.0) + Vec3(std::sin(slope), 0.0, std::cos(slope)) * 0.121);
  state.orientation = Quat(Eigen::AngleAxisd(slope, Vec3::UnitY()));
  world.add_body(0, state);
  while (world.time() < 2.0) {
    world.step();
    ASSERT_FALSE(world.is_asleep(0)) << world.time();
  }
  EXPECT_GT(world.state(0).velocity.norm(), 2.0);
}

// What lay on a block that is taken away is in free fall from then on.
TEST(Sleep, EndsForWhatARemovedBodyHeld) {
  const TerrainSurface terrain = ground(plane_mesh(4.0, 8));
  const std::vector<RigidBody> shapes = {box(60.0, {0.4, 0.4, 0.3})};
  for (const bool held : {false, true}) {  // by the ground, or a fixed body in the air
    World world(shapes, automatic_world(shapes, kSleepGround[0], 6.0), terrain, kSleepGround);
    world.add_body(0, at({0.1, 0.1, held ? 2.0 : 0.16}), held);
    world.add_body(0, at({0.1, 0.1, held ? 2.31 : 0.47}));
    world.add_body(0, at({-1.5, 0.1, 0.16}));
    const std::size_t all = held ? 2 : 3;
    while (world.statistics().sleeping_bodies < all && world.time() < 10.0) world.step();
    ASSERT_EQ(world.statistics().sleeping_bodies, all);
    const double height = world.state(1).position.z(), begin = world.time();
    const Vec3 removed = world.state(0).position;
    world.remove_body(0);
    EXPECT_TRUE(world.is_inactive(0));
    EXPECT_FALSE(world.has_left_terrain(0));
    EXPECT_FALSE(world.is_asleep(1));
    EXPECT_TRUE(world.is_asleep(2));
    EXPECT_TRUE(world.touching_bodies(1).empty());
    EXPECT_EQ(world.contact_force(1).norm(), 0.0);
    while (world.time() < begin + 0.2) world.step();
    const double time = world.time() - begin;
    EXPECT_NEAR(world.state(1).position.z(), height - 0.5 * 9.81 * time * time, 1e-6);
    EXPECT_EQ(world.state(0).position, removed);
    EXPECT_EQ(world.run_until_rest(20.0), StopReason::kRest);
    EXPECT_NEAR(world.state(1).position.z(), 0.15, 0.01);
    EXPECT_LT(world.energy_balance().error, 1e-3);
    world.remove_body(0);  // it is gone already
    EXPECT_TRUE(contains(refusal<SimulationError>([&] { world.remove_body(3); }),
                         "no body 3 to remove, only 3 bodies"));
  }
}

TEST(Sleep, LimitsThatMakeNoSenseAreRefused) {
  const std::vector<RigidBody> shapes = {ball(1.0, 0.1)};
  WorldSettings bad = stiff_world(shapes[0], 1e6);
  bad.sleep_drift = -1.0;
  EXPECT_TRUE(contains(refusal([&] { World(shapes, bad); }), "sleep_drift = -1"));
  bad = stiff_world(shapes[0], 1e6);
  bad.sleep_duration = 0.0;
  EXPECT_TRUE(contains(refusal([&] { World(shapes, bad); }), "sleep_duration = 0"));
}

}  // namespace
}  // namespace clast
