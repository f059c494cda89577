// Many blocks falling into a pile: rocks dropped in a column into a bowl, measured for half a
// second after 1.2 simulated seconds, when most of them touch. Real time is what threads shorten,
// processor time what they must not lengthen. Counters: steps per second, time per touching pair
// and step, pairs that are listed, that keep a search, and that touch, heap memory per block, and a
// digest of the final states, which shows whether two builds or thread counts computed the same.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <cmath>
#include <cstring>

#include "tests/support/test_worlds.hpp"

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

/// Memory that is allocated, bytes.
double heap_memory() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Arguments: blocks, cuts per edge of the icosahedron a rock is made from (10 n^2 + 2 vertices),
/// threads.
void blocks_falling_into_a_pile(benchmark::State& state) {
  const TerrainSurface terrain = ground(bowl());
  const double memory_before = heap_memory();
  World world =
      falling_pile(terrain, static_cast<std::size_t>(state.range(0)),
                   static_cast<int>(state.range(1)), static_cast<unsigned>(state.range(2)));
  world.run_until_rest(1.2);
  state.counters["kB_per_block"] =
      1e-3 * (heap_memory() - memory_before) / static_cast<double>(state.range(0));
  const WorldStatistics before = world.statistics();
  for (auto _ : state) world.run_until_rest(world.time() + 0.025);
  const WorldStatistics after = world.statistics();
  const auto steps = static_cast<double>(after.steps - before.steps);
  const auto pair_steps = static_cast<double>(after.pair_steps - before.pair_steps);
  state.counters["steps_per_s"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
  state.counters["s_per_touching_pair"] =
      benchmark::Counter(pair_steps, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["touching_pairs"] = pair_steps / steps;
  state.counters["near_pairs"] = static_cast<double>(after.near_pairs);
  state.counters["searched_pairs"] = static_cast<double>(after.searched_pairs);
  state.counters["energy_error"] = world.energy_balance().error;
  state.counters["digest"] = digest(world);
}
BENCHMARK(blocks_falling_into_a_pile)
    ->ArgNames({"blocks", "cuts", "threads"})
    ->Args({500, 1, 1})
    ->Args({500, 2, 1})
    ->Args({500, 2, 2})
    ->Args({500, 5, 1})
    ->Args({500, 5, 2})
    ->Iterations(20)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

/// A rock rolls for 0.6 s beside a pile at rest, without touching it. Argument: blocks in the pile;
/// 0: the rock alone. Compare the time per step with that of the moving pile.
void block_beside_a_pile_at_rest(benchmark::State& state) {
  const TerrainSurface terrain = ground(bowl());
  World world = falling_pile(terrain, static_cast<std::size_t>(state.range(0)), 2, 1);
  world.run_until_rest(60.0);
  const WorldStatistics before = world.statistics();
  world.add_body(0, at({7.0, 0.0, 0.15 * 49.0 + 0.9}));
  for (auto _ : state) world.run_to_time(world.time() + 0.6);
  const WorldStatistics after = world.statistics();
  state.counters["s_per_step"] =
      benchmark::Counter(static_cast<double>(after.steps - before.steps),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["asleep"] = static_cast<double>(after.sleeping_bodies);
}
BENCHMARK(block_beside_a_pile_at_rest)
    ->ArgName("blocks")
    ->Arg(0)
    ->Arg(500)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// Layers of rocks that fall onto level ground, as many one above the other for any number of them:
/// what a body and step cost, and how that grows. Argument: blocks.
void layers_falling_onto_a_plane(benchmark::State& state) {
  const auto blocks = static_cast<std::size_t>(state.range(0));
  const double sides = std::sqrt(static_cast<double>(blocks) / 14.0);
  const TerrainSurface terrain = ground(plane_mesh(0.75 * sides + 12.0, 40));
  World world = falling_pile(terrain, blocks, 2, 1, static_cast<std::size_t>(std::lround(sides)));
  world.run_until_rest(0.9);
  const WorldStatistics before = world.statistics();
  for (auto _ : state) world.run_until_rest(world.time() + 0.01);
  const WorldStatistics after = world.statistics();
  const auto steps = static_cast<double>(after.steps - before.steps);
  const auto touching = static_cast<double>(after.pair_steps - before.pair_steps) / steps;
  state.counters["s_per_body_and_step"] =
      benchmark::Counter(steps * static_cast<double>(blocks),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["touching_pairs_per_body"] = touching / static_cast<double>(blocks);
  state.counters["near_pairs_per_body"] =
      static_cast<double>(after.near_pairs) / static_cast<double>(blocks);
}
BENCHMARK(layers_falling_onto_a_plane)
    ->ArgName("blocks")
    ->Arg(500)
    ->Arg(4000)
    ->Iterations(2)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace clast
