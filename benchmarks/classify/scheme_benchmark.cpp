// Every scheme and every index of form against the number of rows of L, I, S.
#include <benchmark/benchmark.h>

#include "classify/schemes.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

void every_class_and_index(benchmark::State& state) {
  Random random(1);
  std::vector<Axes> rows;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    rows.push_back(
        Axes::sorted(random.uniform(0.1, 2.0), random.uniform(0.1, 2.0), random.uniform(0.1, 2.0)));
  }
  std::size_t letters = 0;
  double sum = 0.0;
  for (auto _ : state) {
    for (const Axes& axes : rows) {
      for (const std::string& scheme : scheme_names()) letters += shape_class(scheme, axes).size();
      for (const FormIndex& index : form_index_definitions())
        sum += index.value(axes).value_or(0.0);
    }
  }
  benchmark::DoNotOptimize(letters);
  benchmark::DoNotOptimize(sum);
  state.SetComplexityN(state.range(0));
}
BENCHMARK(every_class_and_index)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

}  // namespace
}  // namespace clast
