// Mass properties of a closed mesh against its number of triangles.
#include "massprops/solid.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

namespace clast {
namespace {

/// A unit sphere of 2 n (n - 1) triangles: n meridians, n - 1 rings, two poles.
TriangleMesh sphere(std::uint32_t n) {
  TriangleMesh mesh;
  const std::uint32_t rings = n - 1;
  for (std::uint32_t ring = 1; ring <= rings; ++ring) {
    const double polar = std::numbers::pi * ring / n;
    for (std::uint32_t meridian = 0; meridian < n; ++meridian) {
      const double azimuth = 2.0 * std::numbers::pi * meridian / n;
      mesh.vertices.emplace_back(std::sin(polar) * std::cos(azimuth),
                                 std::sin(polar) * std::sin(azimuth), std::cos(polar));
    }
  }
  const std::uint32_t top = rings * n;
  const std::uint32_t bottom = top + 1;
  mesh.vertices.emplace_back(0.0, 0.0, 1.0);
  mesh.vertices.emplace_back(0.0, 0.0, -1.0);
  for (std::uint32_t a = 0; a < n; ++a) {
    const std::uint32_t b = (a + 1) % n;
    mesh.triangles.push_back({top, a, b});
    for (std::uint32_t row = 0; row + n < top; row += n) {
      mesh.triangles.push_back({row + a, row + n + a, row + n + b});
      mesh.triangles.push_back({row + a, row + n + b, row + b});
    }
    mesh.triangles.push_back({bottom, top - n + b, top - n + a});
  }
  return mesh;
}

void solid_mass_properties_of_a_sphere(benchmark::State& state) {
  const TriangleMesh mesh = sphere(static_cast<std::uint32_t>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(solid_mass_properties(mesh, 2650.0));
  }
  state.counters["volume_m3"] = solid_mass_properties(mesh, 2650.0).volume;
  state.SetComplexityN(static_cast<std::int64_t>(mesh.triangles.size()));
}
BENCHMARK(solid_mass_properties_of_a_sphere)->RangeMultiplier(2)->Range(16, 512)->Complexity();

}  // namespace
}  // namespace clast
