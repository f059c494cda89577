// Many blocks falling into a pile: rocks of 42 to 252 vertices dropped in a column onto a bowl, for
// two simulated seconds: the last tenth is measured from a copy of the same start each time.
// Counters: steps per second, touching pairs per step, time per touching pair, share of the time
// that one thread works alone, memory per pair, and a digest of the final states, which tells
// whether two builds or thread counts computed the same.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>

#include "dem/stiffness.hpp"
#include "dem/world.hpp"
#include "tests/support/test_rock.hpp"

namespace clast {
namespace {

/// First four bytes of an FNV-1a digest, so that it fits a counter exactly.
double digest(const World& world) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (std::size_t i = 0; i < world.body_count(); ++i) {
    unsigned char bytes[3 * sizeof(double)];
    std::memcpy(bytes, world.state(i).position.data(), sizeof bytes);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211ULL;
  }
  return static_cast<double>(hash >> 32);
}

TriangleMesh bowl() {
  TriangleMesh mesh = plane_mesh(8.0, 32);
  for (Vec3& vertex : mesh.vertices) vertex.z() = 0.15 * vertex.head<2>().squaredNorm();
  return mesh;
}

World falling_pile(const TerrainSurface& terrain, std::size_t blocks, int cuts, unsigned threads) {
  std::vector<RigidBody> shapes;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    shapes.push_back(rock(cuts, {0.30, 0.25, 0.20}, 0.01, 2650.0, seed));
  }
  const std::vector<GroundParameters> zones = {{0.05, 0.7, 0.2}};
  WorldSettings settings;
  settings.stiffness = choose_stiffness(shapes, zones, 10.0, 9.81).stiffness;
  settings.between_bodies = {0.05, 0.6, 0.2};
  settings.threads = threads;
  World world(shapes, settings, terrain, zones);
  Random random(5);
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::size_t layer = i / 36, place = i % 36;
    RigidState state;
    state.position = {0.75 * (static_cast<double>(place % 6) - 2.5),
                      0.75 * (static_cast<double>(place / 6) - 2.5),
                      1.5 + 0.72 * static_cast<double>(layer)};
    state.orientation = random.rotation();
    state.velocity = {0.0, 0.0, -2.0};
    world.add_body(i % shapes.size(), state);
  }
  return world;
}

/// Arguments: blocks, cuts per edge of the icosahedron a rock is made from (10 n^2 + 2 vertices),
/// threads.
void blocks_falling_into_a_pile(benchmark::State& state) {
  const TerrainSurface terrain = ground(bowl());
  World world =
      falling_pile(terrain, static_cast<std::size_t>(state.range(0)),
                   static_cast<int>(state.range(1)), static_cast<unsigned>(state.range(2)));
  world.run_until(1.2);
  const WorldStatistics before = world.statistics();
  for (auto _ : state) {
    for (int i = 0; i < 50; ++i) world.step();
  }
  const WorldStatistics after = world.statistics();
  const auto steps = static_cast<double>(after.steps - before.steps);
  const auto pair_steps = static_cast<double>(after.pair_steps - before.pair_steps);
  state.counters["steps_per_s"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
  state.counters["s_per_touching_pair"] =
      benchmark::Counter(pair_steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["touching_pairs"] = pair_steps / steps;
  state.counters["near_pairs"] = static_cast<double>(after.near_pairs);
  state.counters["searched_pairs"] = static_cast<double>(after.searched_pairs);
  state.counters["energy_error"] = world.energy().error;
  state.counters["digest"] = digest(world);
}
BENCHMARK(blocks_falling_into_a_pile)
    ->ArgNames({"blocks", "cuts", "threads"})
    ->Args({500, 2, 1})
    ->Args({500, 2, 2})
    ->Args({500, 5, 1})
    ->Args({500, 5, 2})
    ->Iterations(20)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace clast
