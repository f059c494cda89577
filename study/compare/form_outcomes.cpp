#include "study/compare/form_outcomes.hpp"

#include <map>

#include "core/statistics/statistics.hpp"
#include "study/compare/detail/run_outcomes.hpp"

namespace clast {

using namespace study_detail;
namespace {

/// Fewer forms make no surface.
constexpr std::size_t kMinForms = 6;

/// Names of blocks that `clast vary` stretched end with both ratios: "B01_il0.8_sl0.5".
bool is_stretched(const std::string& name) {
  const std::size_t at = name.rfind("_il");
  return at != std::string::npos && name.find("_sl", at) != std::string::npos;
}

}  // namespace

std::vector<OutcomeByShape> compute_outcomes_by_shape(const Comparison& comparison) {
  std::vector<OutcomeByShape> outcomes;
  for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
    if (comparison.results[file].persistent_blocks) continue;
    std::map<std::string, Axes> axes;
    for (const BlockSummary& block : comparison.results[file].blocks) {
      axes.emplace(block.library_block(), block.axes);
    }
    if (axes.size() < kMinForms) continue;
    const std::vector<const RunRow*> rows = select_rows_of_file(comparison, file);
    for (const RunOutcome& of_runs : collect_run_outcomes(comparison, file, rows)) {
      std::map<std::string, std::vector<double>> of_form;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        of_form[rows[i]->block->library_block()].push_back(of_runs.values[i]);
      }
      if (of_form.size() < kMinForms) continue;
      OutcomeByShape outcome{file, of_runs.name, of_runs.unit, {}};
      for (const auto& [name, all] : of_form) {
        const SampleSummary summary = summarise_sample(all);
        outcome.forms.push_back(
            {name, axes.at(name), is_stretched(name), summary.count, summary.mean, summary.std});
      }
      outcomes.push_back(std::move(outcome));
    }
  }
  return outcomes;
}

}  // namespace clast
