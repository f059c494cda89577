// Tables of L, I, S against their number of rows: read, classified by every scheme with every
// index, described, written.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "classify/dimension_table.hpp"
#include "classify/population_summary.hpp"
#include "core/files/text_file.hpp"
#include "core/random.hpp"
#include "report/population_report.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

/// Rows as a tape gives them, in centimetres with two decimals.
fs::path make_table(std::int64_t rows) {
  const fs::path path =
      fs::temp_directory_path() / ("clast-benchmark-" + std::to_string(rows) + ".csv");
  Random random(7);
  std::string text = "id,L_cm,I_cm,S_cm\n";
  char line[96];
  for (std::int64_t i = 0; i < rows; ++i) {
    const double I = 60.0 * std::exp(0.5 * random.normal());
    std::snprintf(line, sizeof line, "B%lld,%.2f,%.2f,%.2f\n", static_cast<long long>(i),
                  I * (1.0 + random.uniform()), I, I * (1.0 - 0.8 * random.uniform()));
    text += line;
  }
  write_text_file(path, text);
  return path;
}

double peak_memory_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void read_and_classify(benchmark::State& state) {
  const fs::path path = make_table(state.range(0));
  std::size_t elongated = 0;
  double sum = 0.0;
  for (auto _ : state) {
    const DimensionTable table = read_dimension_table(path);
    for (const MeasuredBlock& block : table.blocks) {
      for (const std::string& scheme : scheme_names()) {
        elongated += shape_class(scheme, block.axes_in_table_unit) == "elongated";
      }
      for (const auto& [name, value] : form_indices(block.axes_in_table_unit)) sum += value;
    }
  }
  benchmark::DoNotOptimize(sum);
  state.counters["elongated"] =
      static_cast<double>(elongated) / static_cast<double>(state.iterations());
  state.counters["rows"] = static_cast<double>(state.range(0));
  fs::remove(path);
}
BENCHMARK(read_and_classify)
    ->RangeMultiplier(10)
    ->Range(1000, 1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// What `clast classify table.csv -o DIR` does: tables, diagrams and report.
void whole_report(benchmark::State& state) {
  const fs::path path = make_table(state.range(0));
  const fs::path folder = fs::temp_directory_path() / "clast-benchmark-report";
  for (auto _ : state) {
    PopulationReport report;
    ReportedPopulation reported;
    reported.population = {"table", read_dimension_table(path).blocks};
    reported.summary = summarise_population(reported.population);
    report.populations.push_back(std::move(reported));
    write_population_report(report, folder);
  }
  state.counters["peak_memory_mb"] = peak_memory_mb();
  state.counters["rows"] = static_cast<double>(state.range(0));
  fs::remove(path);
  fs::remove_all(folder);
}
BENCHMARK(whole_report)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace clast
