// The whole repair of a damaged rock against its number of triangles: holes, spikes, fins, doubled
// sheets, islands, mixed winding, no shared vertices. Peak memory is that of the process so far, so
// the sizes run from small to large.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "reconstruct/repair/repair.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/rock_mesh.hpp"

namespace clast {
namespace {

void repair(benchmark::State& state) {
  const auto frequency = static_cast<int>(state.range(0));  // 20 frequency^2 triangles
  const TriangleMesh dirty =
      damaged(rough_rock_mesh(frequency, {1.0, 0.8, 0.6}, 3, 0.1), Damage::of_intensity(1.0), 1)
          .mesh;
  RepairReport report;
  for (auto _ : state) report = repair_mesh(dirty).report;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["triangles"] = static_cast<double>(dirty.triangles.size());
  state.counters["holes"] = static_cast<double>(report.holes.size());
  state.counters["peak_MiB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
  state.SetComplexityN(static_cast<std::int64_t>(dirty.triangles.size()));
}
BENCHMARK(repair)
    ->Arg(35)
    ->Arg(70)
    ->Arg(158)
    ->Iterations(1)
    ->Unit(benchmark::kSecond)
    ->Complexity();

}  // namespace
}  // namespace clast
