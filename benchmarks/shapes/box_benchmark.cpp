// Boxes against the number of corners of the convex hull: points on a triaxial ellipsoid, every one
// of them a corner. The hull is part of the work.
#include <benchmark/benchmark.h>

#include "core/random.hpp"
#include "shapes/conventional_boxes.hpp"
#include "shapes/convex_hull.hpp"

namespace clast {
namespace {

std::vector<Vec3> corners(std::int64_t count) {
  Random random(1);
  std::vector<Vec3> points;
  for (std::int64_t i = 0; i < count; ++i) {
    points.push_back(random.unit_vector().cwiseProduct(Vec3(1.0, 0.7, 0.45)));
  }
  return points;
}

template <class Box>
void measure(benchmark::State& state, const Box& box) {
  const std::vector<Vec3> points = corners(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(box(points, 0.02));
  state.counters["hull_corners"] = static_cast<double>(extreme_points(points).size());
  state.counters["volume_m3"] = box(points, 0.02).volume();
  state.SetComplexityN(state.range(0));
}

void smallest(benchmark::State& state) {
  measure(state, [](auto& points, double radius) { return smallest_box(points, radius); });
}
void feret(benchmark::State& state) { measure(state, feret_box); }
void pca(benchmark::State& state) { measure(state, pca_box); }

BENCHMARK(smallest)
    ->RangeMultiplier(2)
    ->Range(125, 4000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();
BENCHMARK(feret)->RangeMultiplier(2)->Range(125, 4000)->Unit(benchmark::kMillisecond)->Complexity();
BENCHMARK(pca)->RangeMultiplier(2)->Range(125, 4000)->Unit(benchmark::kMillisecond)->Complexity();

}  // namespace
}  // namespace clast
