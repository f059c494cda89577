// Large grounds, generated: a lidar cloud of 18 million points to a surface of 0.5 m cells, and a
// terrain file of 10 million triangles from disk to the indexed surface the dynamics runs on.
// Counters: peak memory of the process so far in MiB (run one benchmark at a time with
// --benchmark_filter), triangles, and processor time is the benchmark's own.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <cstring>
#include <fstream>

#include "core/random.hpp"
#include "terrain/terrain_file.hpp"
#include "terrain/terrain_input.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

double hills(double x, double y) {
  return 0.4 * x + 20.0 * std::sin(x / 60.0) * std::cos(y / 45.0) + 0.4 * std::sin(x / 0.27);
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // KiB on Linux
}

/// LAS 1.2, format 0, in centimetres: points at random on hills of `side` x `side` metres.
void write_las(const std::filesystem::path& path, std::uint32_t points, double side) {
  std::string header(227, '\0');
  const auto put = [&](std::size_t offset, auto value) {
    std::memcpy(header.data() + offset, &value, sizeof value);
  };
  header.replace(0, 4, "LASF");
  put(24, std::uint8_t{1});
  put(25, std::uint8_t{2});
  put(94, std::uint16_t{227});
  put(96, std::uint32_t{227});
  put(105, std::uint16_t{20});
  put(107, points);
  for (std::size_t k = 0; k < 3; ++k) put(131 + 8 * k, 0.01);
  std::ofstream file(path, std::ios::binary);
  file << header;
  Random random(18);
  std::string record(20, '\0');
  for (std::uint32_t i = 0; i < points; ++i) {
    const double x = random.uniform() * side, y = random.uniform() * side;
    const double z = hills(x, y) + 0.03 * random.normal();
    const std::int32_t steps[3] = {static_cast<std::int32_t>(std::lround(100.0 * x)),
                                   static_cast<std::int32_t>(std::lround(100.0 * y)),
                                   static_cast<std::int32_t>(std::lround(100.0 * z))};
    std::memcpy(record.data(), steps, sizeof steps);
    record[15] = 2;
    file << record;
  }
}

/// Arguments: points in millions at 18 per square metre, and the percentile (-1: mean).
void lidar_to_surface(benchmark::State& state) {
  const ScratchFolder folder;
  const auto points = static_cast<std::uint32_t>(1000000 * state.range(0));
  write_las(folder / "lidar.las", points, std::sqrt(points / 18.0));
  TerrainOptions options{.surface = {folder / "lidar.las"}, .resolution = 0.5};
  if (state.range(1) >= 0) options.percentile = static_cast<double>(state.range(1));
  for (auto _ : state) {
    const Terrain terrain = read_terrain(options);
    const TerrainSurface surface = make_terrain_surface(terrain);
    state.counters["triangles"] = static_cast<double>(terrain.surface.triangles.size());
    benchmark::DoNotOptimize(surface.zone_count());
  }
  state.counters["peak_MiB"] = peak_memory();
}
BENCHMARK(lidar_to_surface)
    ->Args({1, -1})
    ->Args({18, -1})
    ->Args({18, 20})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

/// Argument: squares of two triangles along each side.
void terrain_file_to_indexed_surface(benchmark::State& state) {
  const ScratchFolder folder;
  {
    const auto n = static_cast<std::uint32_t>(state.range(0));
    Terrain terrain;
    for (std::uint32_t j = 0; j <= n; ++j) {
      for (std::uint32_t i = 0; i <= n; ++i) {
        terrain.surface.vertices.emplace_back(0.5 * i, 0.5 * j, hills(0.5 * i, 0.5 * j));
      }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = j * (n + 1) + i, c = a + n + 2;
        terrain.surface.triangles.push_back({a, a + 1, c});
        terrain.surface.triangles.push_back({a, c, c - 1});
      }
    }
    terrain.zone.assign(terrain.surface.triangles.size(), 0);
    terrain.zone_names = {"ground"};
    write_terrain(folder / "ground.h5", terrain);
  }
  for (auto _ : state) {
    const TerrainSurface surface =
        make_terrain_surface(read_terrain({.surface = {folder / "ground.h5"}}));
    state.counters["triangles"] = static_cast<double>(surface.mesh().triangles.size());
  }
  state.counters["peak_MiB"] = peak_memory();
}
BENCHMARK(terrain_file_to_indexed_surface)
    ->Arg(224)
    ->Arg(707)
    ->Arg(2237)  // 10,008,338 triangles
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace clast
