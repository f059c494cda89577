// Blocks released one after the other that stay.
#include "dem/simulation/sequence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

const std::vector<GroundParameters> kGround = {{0.05, 0.7, 0.3}};

SequenceSettings settings_for(const std::vector<RigidBody>& shapes, double max_time = 20.0) {
  SequenceSettings settings;
  settings.world.stiffness = choose_stiffness(shapes, kGround, 6.0, 9.81).stiffness;
  settings.world.between_bodies = kGround[0];
  settings.max_time = max_time;
  return settings;
}

std::vector<SequenceResult> sequence(const TerrainSurface& terrain,
                                     const std::vector<RigidBody>& shapes,
                                     const std::vector<SequenceBlock>& blocks,
                                     double max_time = 20.0, const SequenceObserver& observe = {}) {
  return simulate_sequence(terrain, kGround, shapes, blocks, settings_for(shapes, max_time),
                           {observe});
}

TEST(Sequence, OfOneBlockIsItsRelease) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {box(50.0, {0.4, 0.3, 0.2}, 0.01)};
  RigidState start = at({0.3, 0.2, 0.6}, {1.5, 0.0, 0.0});
  start.angular_velocity = {0.0, 2.0, 0.0};
  ReleaseSettings alone;
  alone.stiffness = settings_for(shapes).world.stiffness;
  alone.stiffness.max_time_step = 0.0;
  const ReleaseResult expected = simulate_release(terrain, kGround, shapes[0], start, alone);
  const ReleaseResult found = sequence(terrain, shapes, {{0, start}})[0].release;
  ASSERT_EQ(found.stop_reason, StopReason::kRest);
  EXPECT_LT((found.final_state.position - expected.final_state.position).norm(), 0.01);
  EXPECT_NEAR(found.path_length, expected.path_length, 0.03);
  EXPECT_NEAR(found.max_speed, expected.max_speed, 0.01);
  EXPECT_NEAR(found.energy.initial, expected.energy.initial, 1e-6);
  EXPECT_LT(found.energy.error, 1e-3);
  EXPECT_FALSE(found.below_ground);
}

std::vector<EnergySample> energies_of(const TerrainSurface& terrain,
                                      const std::vector<RigidBody>& shapes,
                                      const std::vector<SequenceBlock>& blocks,
                                      const SequenceSettings& settings) {
  std::vector<EnergySample> samples;
  simulate_sequence(terrain, kGround, shapes, blocks, settings,
                    {.energy = [&](const EnergySample& sample) { samples.push_back(sample); }});
  return samples;
}

// A box that slides on level ground loses its kinetic energy to friction with the ground.
TEST(SequenceEnergies, AreSampledUntilAllIsDissipated) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {box(50.0, {0.6, 0.6, 0.1})};
  SequenceSettings settings = settings_for(shapes);
  settings.energy_interval = 0.1;
  const auto samples =
      energies_of(terrain, shapes, {{0, at({0.0, 0.0, 0.05}, {3.0, 0.0, 0.0})}}, settings);
  ASSERT_GT(samples.size(), 5u);  // it slides for v/(mu g) = 0.44 s
  EXPECT_EQ(samples.front().time, 0.0);
  EXPECT_EQ(samples.front().moving, 1u);
  EXPECT_NEAR(samples.front().translational, 225.0, 1e-9);
  EXPECT_NEAR(samples.front().potential, 50.0 * 9.81 * 0.05, 1e-9);
  const double brought = samples.front().sum();
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    EXPECT_GE(samples[i].time, 0.1 * static_cast<double>(i));
    EXPECT_LT(samples[i].time, 0.1 * static_cast<double>(i + 1));
    EXPECT_NEAR(samples[i].sum(), brought, 1e-3 * brought);
    EXPECT_GE(samples[i].on_ground.friction, samples[i - 1].on_ground.friction);
  }
  EXPECT_EQ(samples.back().moving, 0u);
  EXPECT_NEAR(samples.back().on_ground.friction, 225.0, 0.02 * 225.0);
  EXPECT_EQ(samples.back().between_bodies.sum(), 0.0);
}

// Two boxes meet head on while they fall: what they lose then, they lose to each other.
TEST(SequenceEnergies, SeparateGroundAndBlocks) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {box(50.0, {0.4, 0.4, 0.4})};
  SequenceSettings settings = settings_for(shapes);
  settings.at_once = true;
  settings.energy_interval = 0.02;
  const std::vector<SequenceBlock> blocks = {{0, at({-0.5, 0.0, 3.0}, {4.0, 0.0, 0.0})},
                                             {0, at({0.5, 0.0, 3.0}, {-4.0, 0.0, 0.0})}};
  const auto samples = energies_of(terrain, shapes, blocks, settings);
  // They meet after 0.075 s, and reach the ground after 0.76 s at the earliest. Both laws return
  // e_n^2 of the energy.
  const auto before_ground = std::find_if(samples.begin(), samples.end(),
                                          [](const auto& sample) { return sample.time > 0.5; });
  ASSERT_NE(before_ground, samples.end());
  EXPECT_EQ(before_ground->on_ground.sum(), 0.0);
  EXPECT_NEAR(before_ground->between_bodies.normal, 0.95 * 800.0, 0.02 * 800.0);
  EXPECT_GT(samples.back().on_ground.sum(), 0.9 * 2.0 * 50.0 * 9.81 * 2.8);
  EXPECT_NEAR(samples.back().sum(), samples.front().sum(), 1e-3 * samples.front().sum());
}

TEST(SequenceEnergies, ChangeNothing) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {box(60.0, {0.4, 0.4, 0.3})};
  const SequenceBlock block{0, at({0.1, 0.1, 0.36})};
  SequenceSettings settings = settings_for(shapes);
  const auto without =
      simulate_sequence(terrain, kGround, shapes, std::vector{block, block}, settings);
  settings.energy_interval = 0.01;
  const auto with = simulate_sequence(terrain, kGround, shapes, std::vector{block, block}, settings,
                                      {.energy = [](const EnergySample&) {}});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(with[i].release.final_state.position, without[i].release.final_state.position);
    EXPECT_EQ(with[i].release.duration, without[i].release.duration);
  }
  settings.energy_interval = -1.0;
  EXPECT_TRUE(
      contains(refusal([&] { settings.check(); }), "energy_interval = -1; must be 0 or more"));
}

// What a block takes along when it leaves the terrain is neither there nor dissipated.
TEST(SequenceEnergies, KnowWhatLeft) {
  const TerrainSurface terrain = ground(plane_mesh(2.0, 20));
  const std::vector<RigidBody> shapes = {box(50.0, {0.2, 0.2, 0.2})};
  SequenceSettings settings = settings_for(shapes);
  settings.energy_interval = 0.05;
  const auto samples =
      energies_of(terrain, shapes, {{0, at({0.0, 0.0, 1.5}, {12.0, 0.0, 0.0})}}, settings);
  EXPECT_GT(samples.back().departed, 0.5 * 50.0 * 144.0 * 0.9);
  EXPECT_EQ(samples.back().translational, 0.0);
  EXPECT_EQ(samples.back().potential, 0.0);
  EXPECT_NEAR(samples.back().sum(), samples.front().sum(), 1e-6 * samples.front().sum());
}

TEST(Sequence, BlocksReleasedAtOnePlacePileUp) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {box(60.0, {0.4, 0.4, 0.3})};
  const SequenceBlock block{0, at({0.1, 0.1, 0.16})};
  const auto results = sequence(terrain, shapes, {block, block, block});
  // Each contact yields in proportion to the blocks that it carries.
  const double depth = choose_stiffness(shapes, kGround, 6.0, 9.81).settled_depth;
  double height = -0.15;
  for (std::size_t i = 0; i < 3; ++i) {
    const ReleaseResult& release = results[i].release;
    height += 0.3 - depth * static_cast<double>(3 - i);
    EXPECT_EQ(release.stop_reason, StopReason::kRest);
    EXPECT_NEAR(release.final_state.position.z(), height, 0.1 * depth);
    EXPECT_EQ(results[i].blocks_hit, i == 0 ? 0u : 1u);
    EXPECT_LT(release.energy.error, 1e-3);
  }
  EXPECT_NEAR(results[0].later_displacement, 2.0 * depth, 0.1 * depth);
  EXPECT_EQ(results[0].raise_height, 0.0);
  // Clear of the sphere around the block that lies there.
  const double diameter = 2.0 * shapes[0].bounding_radius();
  EXPECT_NEAR(results[1].raise_height, 0.15 - depth + diameter - 0.16, 0.1 * depth);
  EXPECT_GT(results[2].released_at, results[1].released_at);
}

// A ball that rolls down a channel on its own is stopped by a box that lies in its way.
TEST(Sequence, ABlockThatStaysStopsTheNext) {
  TriangleMesh channel = plane_mesh(8.0, 32);
  for (Vec3& p : channel.vertices) p.z() = 0.5 * std::abs(p.y()) - 0.5 * p.x();
  const TerrainSurface terrain = ground(channel);
  const std::vector<RigidBody> shapes = {ball(40.0, 0.2), box(900.0, {0.9, 0.9, 0.6})};
  const SequenceBlock rolling{0, at({-4.0, 0.0, 2.3})}, lying{1, at({0.0, 0.0, 0.8})};
  const auto alone = sequence(terrain, shapes, {rolling});
  EXPECT_EQ(alone[0].release.stop_reason, StopReason::kLeftTerrain);
  const auto both = sequence(terrain, shapes, {lying, rolling});
  EXPECT_EQ(both[0].release.stop_reason, StopReason::kRest);
  EXPECT_EQ(both[1].release.stop_reason, StopReason::kRest);
  EXPECT_LT(both[1].release.final_state.position.x(), both[0].release.final_state.position.x());
  EXPECT_EQ(both[1].blocks_hit, 1u);
}

TEST(Sequence, ABlockThatIsHitLaterEndsWhereItWasMovedTo) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {box(20.0, {0.3, 0.3, 0.2}), ball(60.0, 0.2)};
  const SequenceBlock lying{0, at({0.0, 0.0, 0.11})},
      thrown{1, at({-1.5, 0.0, 0.25}, {6.0, 0.0, 0.0})};
  std::vector<double> times;
  const auto results =
      sequence(terrain, shapes, {lying, thrown}, 20.0, [&](std::size_t block, const MotionStep& s) {
        if (block == 0) times.push_back(s.end_time);
      });
  EXPECT_GT(results[0].later_displacement, 0.3);
  EXPECT_NEAR(results[0].release.final_state.position.x(), results[0].later_displacement, 0.1);
  EXPECT_EQ(results[0].blocks_hit, 0u);  // it was hit, after its own release
  EXPECT_EQ(results[1].blocks_hit, 1u);
  // What is seen of it goes on, by the clock of its own release.
  EXPECT_GT(times.back(), results[1].released_at);
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
}

TEST(Sequence, GoesOnWhenABlockDoesNotStopInTime) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {ball(10.0, 0.2)};
  const auto results =
      sequence(terrain, shapes, {{0, at({0.0, 0.0, 3.0})}, {0, at({2.0, 0.0, 3.0})}}, 0.3);
  EXPECT_NEAR(results[0].release.duration, 0.3, 1e-9);
  EXPECT_NEAR(results[1].released_at, 0.3, 1e-9);
  EXPECT_EQ(results[0].release.stop_reason, StopReason::kMaxTime);
}

// Two zones, west and east of x = 0, of which the east is cleared.
TEST(Sequence, BlocksThatRestInAClearedZoneMakeRoomForTheNext) {
  TriangleMesh plane = plane_mesh(10.0, 20);
  std::vector<std::uint16_t> zones;
  for (const auto& triangle : plane.triangles) {
    double x = 0.0;
    for (const std::uint32_t vertex : triangle) x += plane.vertices[vertex].x();
    zones.push_back(x > 0.0 ? 1 : 0);
  }
  const TerrainSurface terrain(std::move(plane), std::move(zones));
  const std::vector<GroundParameters> parameters = {kGround[0], kGround[0]};
  const std::vector<RigidBody> shapes = {box(60.0, {0.4, 0.4, 0.3})};
  SequenceSettings settings = settings_for(shapes);
  settings.cleared_zones = {1};
  const SequenceBlock east{0, at({0.6, 0.1, 0.2})}, west{0, at({-0.6, 0.1, 0.2})};
  const std::vector<SequenceBlock> blocks = {east, west, east, west};
  const auto results = simulate_sequence(terrain, parameters, shapes, blocks, settings);
  for (const std::size_t block : {0u, 2u}) {
    EXPECT_EQ(results[block].raise_height, 0.0);
    ASSERT_TRUE(results[block].removed_at);
    EXPECT_EQ(*results[block].removed_at, results[block + 1].released_at);
    EXPECT_EQ(results[block].release.stop_reason, StopReason::kRest);
    EXPECT_NEAR(results[block].release.final_state.position.x(), 0.6, 0.01);
    EXPECT_GT(results[block].release.settled_penetration, 0.0);
    EXPECT_EQ(results[block].later_displacement, 0.0);
  }
  EXPECT_FALSE(results[1].removed_at || results[3].removed_at);
  EXPECT_GT(results[3].raise_height, 0.1);
  for (const SequenceResult& result : results) EXPECT_LT(result.release.energy.error, 1e-3);
}

// Side by side each falls as it would alone; above each other they pile up, released as they are.
TEST(Sequence, BlocksReleasedAtOnceFallTogether) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {box(60.0, {0.4, 0.4, 0.3}), box(50.0, {0.5, 0.3, 0.3})};
  SequenceSettings settings = settings_for(shapes);
  settings.at_once = true;
  const SequenceBlock left{0, at({-2.0, 0.0, 0.5})}, right{1, at({2.0, 0.3, 0.9})},
      above{0, at({-2.0, 0.0, 0.85})};
  const auto release = [&](const std::vector<SequenceBlock>& blocks) {
    return simulate_sequence(terrain, kGround, shapes, blocks, settings);
  };
  const auto apart = release({left, right});
  double initial = 0.0, friction = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto alone = release({i == 0 ? left : right});
    EXPECT_EQ(apart[i].released_at, 0.0);
    EXPECT_EQ(apart[i].blocks_hit, 0u);
    // Alone it falls asleep while it still settles into its contacts; here one waits for the other.
    EXPECT_LT(
        (apart[i].release.final_state.position - alone[0].release.final_state.position).norm(),
        1e-4);
    initial += alone[0].release.energy.initial;
    friction += alone[0].release.energy.friction;
  }
  // They share one balance and one duration.
  EXPECT_EQ(apart[0].release.duration, apart[1].release.duration);
  EXPECT_NEAR(apart[0].release.energy.initial, initial, 1e-9 * initial);
  EXPECT_NEAR(apart[1].release.energy.friction, friction, 1e-6 * initial);
  const auto pile = release({left, above});
  EXPECT_EQ(pile[1].raise_height, 0.0);
  EXPECT_EQ(pile[0].blocks_hit, 1u);
  EXPECT_EQ(pile[1].blocks_hit, 1u);
  EXPECT_EQ(pile[0].later_displacement, 0.0);
  const double depth = choose_stiffness(shapes, kGround, 6.0, 9.81).settled_depth;
  EXPECT_NEAR(pile[1].release.final_state.position.z(), 0.45, 3.5 * depth);
  for (const SequenceResult& result : pile) {
    EXPECT_EQ(result.release.stop_reason, StopReason::kRest);
    EXPECT_LT(result.release.energy.error, 1e-3);
  }
  // Nothing is raised out of another.
  const SequenceBlock inside{0, at({-2.0, 0.0, 0.7})};
  const std::string message = refusal<SimulationError>([&] { release({left, inside}); });
  EXPECT_TRUE(contains(message, "body 0") || contains(message, "body 1")) << message;
}

TEST(Sequence, ReportsHowFarItIs) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {box(60.0, {0.4, 0.4, 0.3})};
  const SequenceBlock block{0, at({0.1, 0.1, 0.36})};
  std::vector<SequenceProgress> seen;
  std::vector<std::size_t> resting;
  simulate_sequence(terrain, kGround, shapes, std::vector{block, block}, settings_for(shapes),
                    {.progress = [&](const SequenceProgress& now) {
                      seen.push_back(now);
                      resting.push_back(now.count_resting());
                    }});
  ASSERT_GT(seen.size(), 100u);
  EXPECT_EQ(seen.front().released, 1u);
  EXPECT_EQ(resting.front(), 0u);
  EXPECT_EQ(seen.back().released, 2u);
  EXPECT_EQ(resting.back(), 2u);
  for (std::size_t i = 1; i < seen.size(); ++i) {
    EXPECT_GT(seen[i].time, seen[i - 1].time);
    EXPECT_GE(seen[i].released, seen[i - 1].released);
    EXPECT_FALSE(seen[i].settling);
  }
}

// Held blocks stay where they are, whatever hits them, until their time comes.
TEST(Sequence, HoldsBlocksUntilTheirTime) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {box(60.0, {0.4, 0.4, 0.3})};
  SequenceSettings settings = settings_for(shapes);
  settings.at_once = true;
  const auto release = [&](const std::vector<SequenceBlock>& blocks,
                           const SequenceObserver& observe = {}) {
    return simulate_sequence(terrain, kGround, shapes, blocks, settings, {observe});
  };
  RigidState thrown = at({-2.0, 0.0, 0.7}, {8.0, 0.0, 0.0});
  const SequenceBlock hits{0, thrown}, held{0, at({0.0, 0.05, 0.55}), 5.0},
      apart{0, at({3.0, 0.3, 1.1}), 7.5};
  double first_seen = -1.0;
  const auto found = release({hits, held, apart}, [&](std::size_t block, const MotionStep& step) {
    if (block != 1) return;
    if (first_seen < 0.0) {
      first_seen = step.begin_time;
      EXPECT_EQ(step.begin.position, held.start.position);
    }
  });
  EXPECT_NEAR(first_seen, 5.0, 1e-9);
  EXPECT_EQ(found[0].released_at, 0.0);
  EXPECT_EQ(found[1].released_at, 5.0);
  EXPECT_EQ(found[2].released_at, 7.5);
  // The thrown one is stopped by the held one.
  EXPECT_EQ(found[0].blocks_hit, 1u);
  EXPECT_LT(found[0].release.final_state.position.x(), -0.3);
  EXPECT_LT(found[1].release.final_state.position.z(), 0.5);
  EXPECT_GT(found[2].release.duration, 7.5);
  // What is alone falls as it would at once, later.
  const SequenceBlock now{0, apart.start};
  const auto alone = release({now});
  EXPECT_LT((found[2].release.final_state.position - alone[0].release.final_state.position).norm(),
            1e-4);
  const auto later = release({apart});
  EXPECT_LT((later[0].release.final_state.position - alone[0].release.final_state.position).norm(),
            1e-9);
  EXPECT_NEAR(later[0].release.duration, 7.5 + alone[0].release.duration, 1e-6);
  // A held block brings its energy when it is freed, and no balance is lost.
  EXPECT_NEAR(later[0].release.energy.initial, alone[0].release.energy.initial, 1e-9);
  for (const SequenceResult& result : found) {
    EXPECT_EQ(result.release.stop_reason, StopReason::kRest);
    EXPECT_LT(result.release.energy.error, 1e-3);
  }
  settings.world.threads = 2;
  const auto threads = release({hits, held, apart});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(threads[i].release.final_state.position, found[i].release.final_state.position);
  }
}

TEST(Sequence, RefusesWhatIsNoSequence) {
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  const std::vector<RigidBody> shapes = {ball(10.0, 0.2)};
  EXPECT_TRUE(contains(refusal([&] {
                         sequence(terrain, shapes, {{0, at({0, 0, 1})}}, 0.0);
                       }),
                       "max_time = 0"));
  EXPECT_TRUE(contains(refusal<SimulationError>([&] {
                         sequence(terrain, shapes, {{0, at({50, 0, 1})}});
                       }),
                       "body 0"));
  EXPECT_TRUE(contains(refusal([&] {
                         sequence(terrain, shapes, {{0, at({0, 0, 1}), -1.0}});
                       }),
                       "release_time = -1; must be 0 or more"));
}

}  // namespace
}  // namespace clast
