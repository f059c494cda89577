// Whole releases of a concave rock of about 600 kg on a rough slope of 36 degrees in 0.5 m cells
// with 0.10 m roughness, until it stops or leaves: e_n^2 0.01, mu 0.70, mu_R 0.18.
// Counters: time per step (contact steps and pieces of flight), processor time per 10 simulated
// seconds and per release, steps, and a digest of the final states, which shows whether two builds
// computed the same.
#include <benchmark/benchmark.h>

#include <cstring>

#include "tests/support/tested_slope.hpp"

namespace clast {
namespace {

constexpr int kReleases = 8;

/// First four bytes of an FNV-1a digest, so that it fits a counter exactly.
double digest(const std::vector<RigidState>& states) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const RigidState& state : states) {
    unsigned char bytes[3 * sizeof(double)];
    std::memcpy(bytes, state.position.data(), sizeof bytes);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211ULL;
  }
  return static_cast<double>(hash >> 32);
}

benchmark::Counter per_run(double value) {
  return benchmark::Counter(
      value, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Arguments: cells per side of the slope, cuts per edge of the icosahedron the rock is made from
/// (10 n^2 + 2 vertices), and whether stiffness and step are pinned to 1e8 N/m and 2e-5 s.
void rock_on_a_rough_slope(benchmark::State& state) {
  const RigidBody body = tested_rock(static_cast<int>(state.range(1)));
  const TerrainSurface terrain = ground(tested_slope(static_cast<int>(state.range(0))));
  ReleaseSettings settings = tested_settings(body);
  if (state.range(2) != 0) settings.stiffness = {1e8, 1e8, 1e7, 2e-5};

  double simulated = 0.0;
  std::uint64_t steps = 0;
  std::vector<RigidState> ends;
  for (auto _ : state) {
    ends.clear();
    simulated = 0.0;
    steps = 0;
    for (std::uint64_t i = 0; i < kReleases; ++i) {
      const ReleaseResult result =
          simulate_release(terrain, kTestedZones, body, tested_start(i), settings);
      ends.push_back(result.final_state);
      simulated += result.duration;
      steps += result.contact_steps + result.flight_segments;
    }
  }
  state.counters["s_per_step"] = per_run(static_cast<double>(steps));
  state.counters["cpu_s_per_10_s"] = per_run(simulated / 10.0);
  state.counters["cpu_s_per_release"] = per_run(kReleases);
  state.counters["steps"] = static_cast<double>(steps);
  state.counters["digest"] = digest(ends);
}
BENCHMARK(rock_on_a_rough_slope)
    ->ArgNames({"cells", "cuts", "pinned"})
    ->Args({70, 2, 0})
    ->Args({70, 5, 0})
    ->Args({224, 5, 0})
    ->Args({2236, 5, 0})
    ->Args({70, 14, 0})
    ->Args({70, 5, 1})
    ->Args({224, 5, 1})
    ->Unit(benchmark::kMillisecond);

/// Argument: cells per side.
void loading_a_slope(benchmark::State& state) {
  const TriangleMesh mesh = tested_slope(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(ground(mesh).zone_count());
  state.counters["s_per_triangle"] = per_run(static_cast<double>(mesh.triangles.size()));
}
BENCHMARK(loading_a_slope)
    ->ArgName("cells")
    ->Arg(70)
    ->Arg(224)
    ->Arg(2236)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace clast
