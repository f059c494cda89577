// Motions that go on from a checkpoint, to the same bits.
#include <gtest/gtest.h>

#include <sstream>

#include "core/byte_archive.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "dem/contact/elastoplastic_law.hpp"
#include "dem/contact/energy_restitution_law.hpp"
#include "dem/contact/spring_dashpot_law.hpp"
#include "dem/simulation/sequence.hpp"
#include "tests/support/test_worlds.hpp"

namespace clast {
namespace {

// Everything that can have a past: soil that remembers dents, drag, friction that grows with slip.
GroundParameters soil() {
  GroundParameters soil{0.1, 0.5, 0.1};
  soil.friction_min = 0.2;
  soil.slip_growth = 2.0;
  soil.slip_memory = 0.1;
  soil.scar_drag = 0.5;
  soil.soil_density = 500.0;
  soil.soil_memory = 0.3;
  return soil;
}

std::vector<RigidBody> mixed_shapes() {
  return {rock(2, {0.30, 0.25, 0.20}, 0.01, 2650.0, 1), box(60.0, {0.5, 0.4, 0.3}, 0.02),
          capsule(40.0, 0.4, 0.15), ball(50.0, 0.2), ellipsoid(80.0, {0.35, 0.25, 0.2}, 0.01, 3)};
}

class MixedPile {
 public:
  MixedPile(const GroundParameters& on_ground, const ContactLaw& law)
      : zones_{on_ground}, terrain_(ground(bowl())) {
    settings_.law = law;
    settings_.sleep_duration = 0.2;
    settings_.between_bodies = {0.05, 0.6, 0.2};
    settings_.stiffness = choose_stiffness(shapes_, zones_, 8.0, 9.81).stiffness;
  }
  World empty(unsigned threads = 1) const {
    WorldSettings settings = settings_;
    settings.threads = threads;
    return {shapes_, settings, terrain_, zones_};
  }
  World falling() const {
    World world = empty();
    Random random(3);
    for (int i = 0; i < 20; ++i) {
      RigidState state =
          at({0.9 * (i % 3 - 1), 0.9 * (i / 3 % 3 - 1), 1.0 + 0.8 * (i / 9)}, {0.3, 0.0, -2.0});
      state.orientation = random.rotation();
      world.add_body(static_cast<std::size_t>(i) % shapes_.size(), state, i == 0);
    }
    return world;
  }

 private:
  std::vector<RigidBody> shapes_ = mixed_shapes();
  std::vector<GroundParameters> zones_;
  WorldSettings settings_;
  TerrainSurface terrain_;
};

std::string saved(const World& world) {
  std::ostringstream text;
  ByteWriter writer(text);
  world.save(writer);
  return text.str();
}

void restore(World& world, const std::string& bytes) {
  ByteReader reader(bytes);
  world.restore(reader);
  EXPECT_TRUE(reader.at_end());
}

/// What a checkpoint leaves out would show in the next ones.
void expect_same_motion(const MixedPile& pile) {
  World world = pile.falling();
  for (int part = 0; part < 24; ++part) {
    if (part == 10) world.remove_body(7);
    if (part == 11) world.release_bodies(std::vector<std::size_t>{0});
    const std::string before = saved(world);
    const double end = world.time() + 0.17;
    world.run_to_time(end);
    World copy = pile.empty(1 + part % 2);
    restore(copy, before);
    ASSERT_EQ(copy.body_count(), 20u);
    copy.run_to_time(end);
    ASSERT_EQ(copy.statistics().contact_points, world.statistics().contact_points) << part;
    ASSERT_TRUE(saved(copy) == saved(world)) << part;
  }
  EXPECT_GT(world.statistics().touching_pairs, 20u);
  EXPECT_GT(world.statistics().sleeping_bodies, 0u);
}

TEST(WorldCheckpoint, GoesOnToTheSameBits) {
  expect_same_motion({{0.1, 0.5, 0.1}, EnergyRestitutionLaw()});
  expect_same_motion({{0.1, 0.5, 0.1}, SpringDashpotLaw()});
}

TEST(WorldCheckpoint, KeepsDentsSlipAndDrag) { expect_same_motion({soil(), ElastoplasticLaw()}); }

TEST(WorldCheckpoint, ThatEndsTooEarlyIsRefused) {
  const MixedPile pile({0.1, 0.5, 0.1}, EnergyRestitutionLaw());
  const std::string whole = saved(pile.falling());
  World world = pile.empty();
  ByteReader half(std::string_view(whole).substr(0, whole.size() / 2));
  EXPECT_THROW(world.restore(half), InputError);
}

/// All that a sequence gives, as bytes.
struct Heard {
  std::string motion, energy, results;
  std::vector<std::string> checkpoints;
  std::vector<std::size_t> motion_then, energy_then;  ///< sizes when they were taken

  /// @param every  steps between two checkpoints
  Heard(const TerrainSurface& terrain, const std::vector<GroundParameters>& zones,
        const std::vector<RigidBody>& shapes, const std::vector<SequenceBlock>& blocks,
        const SequenceSettings& settings, std::size_t every, const std::string& from = "") {
    std::ostringstream moved, spent;
    ByteWriter moves(moved), energies(spent);
    ByteReader reader(from);
    std::size_t steps = 0;
    std::vector<SequenceResult> list =
        simulate_sequence(terrain, zones, shapes, blocks, settings,
                          {[&](std::size_t block, const MotionStep& step) {
                             RigidState end = step.end;
                             double time = step.end_time;
                             moves(block, time, end);
                           },
                           [&](EnergySample sample) { energies(sample); },
                           [&](const SequenceProgress& progress) {
                             if (++steps % every != 0) return;
                             std::ostringstream state;
                             ByteWriter writer(state);
                             progress.save_state(writer);
                             checkpoints.push_back(state.str());
                             motion_then.push_back(moved.str().size());
                             energy_then.push_back(spent.str().size());
                           }},
                          from.empty() ? nullptr : &reader);
    motion = moved.str();
    energy = spent.str();
    results = serialized_bytes(list);
  }
};

void expect_same_sequence(const std::vector<RigidBody>& shapes,
                          const std::vector<SequenceBlock>& blocks, SequenceSettings settings,
                          std::size_t every) {
  const std::vector<GroundParameters> zones = {{0.05, 0.7, 0.3}};
  const TerrainSurface terrain = ground(plane_mesh(10.0, 20));
  settings.world.stiffness = choose_stiffness(shapes, zones, 6.0, 9.81).stiffness;
  settings.world.between_bodies = zones[0];
  settings.energy_interval = 0.05;
  const Heard whole(terrain, zones, shapes, blocks, settings, every);
  ASSERT_GT(whole.checkpoints.size(), 4u);
  for (std::size_t i = 0; i < whole.checkpoints.size(); ++i) {
    const Heard rest(terrain, zones, shapes, blocks, settings, every, whole.checkpoints[i]);
    EXPECT_TRUE(rest.results == whole.results) << i;
    EXPECT_TRUE(rest.motion == whole.motion.substr(whole.motion_then[i])) << i;
    EXPECT_TRUE(rest.energy == whole.energy.substr(whole.energy_then[i])) << i;
  }
}

TEST(SequenceCheckpoint, OfBlocksOneAfterTheOther) {
  SequenceSettings settings;
  settings.max_time = 10.0;
  std::vector<SequenceBlock> blocks;
  for (std::size_t i = 0; i < 4; ++i) {
    blocks.push_back({i % 2, at({0.1 * static_cast<double>(i), 0.0, 0.6}, {1.5, 0.0, 0.0})});
  }
  expect_same_sequence({box(60.0, {0.5, 0.4, 0.3}, 0.02), ball(50.0, 0.2)}, blocks, settings, 700);
}

TEST(SequenceCheckpoint, OfBlocksThatAreHeldAndThatSettle) {
  SequenceSettings settings;
  settings.max_time = 10.0;
  settings.at_once = true;
  std::vector<SequenceBlock> blocks;
  for (int i = 0; i < 5; ++i) {
    blocks.push_back({0, at({0.6 * (i % 2), 0.6 * (i / 2), 0.4})});
  }
  blocks.back().start.position = {2.5, 0.2, 0.31};
  blocks.back().release_time = 0.4;
  // A wall that holds the first four, and goes at 0.2 s.
  settings.confining_walls.push_back(
      {.shape = 1, .pose = at({-1.0, 0.3, 0.0}), .first = 0, .end = 4});
  settings.confining_walls.back().removed_at = 0.2;
  expect_same_sequence({box(60.0, {0.5, 0.4, 0.3}, 0.02), box(1.0, {1.0, 6.0, 6.0})}, blocks,
                       settings, 400);
}

}  // namespace
}  // namespace clast
