// Mass properties of rounded concave rocks, by columns: against the number of core vertices, the
// asked accuracy and the grain of the surface, and of real scans used as cores.
// Counters: core vertices, columns' stated error, and the volume, which shows whether two builds
// computed the same.
#include "massprops/sphero.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

#include "reconstruct/scan.hpp"
#include "shapes/oriented_box.hpp"
#include "tests/support/reference_data.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

void measure(benchmark::State& state, const SpheroPolyhedron& body, double accuracy) {
  MassProperties properties;
  for (auto _ : state) {
    properties = sphero_mass_properties(body, 2650.0, accuracy);
    benchmark::DoNotOptimize(properties);
  }
  state.counters["vertices"] = static_cast<double>(body.vertices.size());
  state.counters["stated_error"] = properties.relative_error;
  state.counters["volume_m3"] = properties.volume;
}

/// Arguments: cuts per edge of the icosahedron (10 n^2 + 2 vertices), scatter of the vertices in
/// per cent of the edge length, radius in per mille of the shortest half axis, and the accuracy as
/// its negative decimal power.
void concave_rock(benchmark::State& state) {
  const TriangleMesh core = rough_rock_mesh(static_cast<int>(state.range(0)), {0.42, 0.36, 0.30}, 3,
                                            1e-2 * static_cast<double>(state.range(1)));
  const double radius = 0.30e-3 * static_cast<double>(state.range(2));
  measure(state, make_sphero_polyhedron(core, radius),
          std::pow(10.0, -static_cast<double>(state.range(3))));
}
BENCHMARK(concave_rock)
    ->ArgNames({"cuts", "grain", "radius", "digits"})
    ->Args({5, 0, 40, 4})
    ->Args({5, 20, 40, 4})
    ->Args({5, 20, 100, 4})
    ->Args({5, 20, 40, 6})
    ->Args({16, 10, 40, 4})
    ->Args({35, 0, 40, 4})
    ->Args({35, 10, 20, 4})
    ->Args({35, 10, 40, 4})
    ->Args({35, 10, 100, 4})
    ->Args({35, 30, 40, 4})
    ->Args({35, 10, 40, 6})
    ->Unit(benchmark::kMillisecond);

/// A scan used as the core, with a radius of so many per mille of its shortest side.
void real_scan(benchmark::State& state, const char* file, double share) {
  TriangleMesh core;
  try {
    core = read_scan(test_data(file)).mesh;
  } catch (const Error& error) {
    state.SkipWithError(error.what());
    return;
  }
  const double radius = share * smallest_box(core.vertices).lengths[2];
  measure(state, make_sphero_polyhedron(core, radius), 1e-4);
}
BENCHMARK_CAPTURE(real_scan, stone14_2_percent, "meshes/eesd_stone14.stl", 0.02)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(real_scan, stone15_2_percent, "meshes/eesd_stone15.stl", 0.02)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(real_scan, stone15_5_percent, "meshes/eesd_stone15.stl", 0.05)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(real_scan, rock_s02_2_percent, "meshes/eesd_S02.stl", 0.02)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace clast
