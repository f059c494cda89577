#include "study/compare/form_outcomes.hpp"

#include <algorithm>
#include <map>

#include "core/statistics/statistics.hpp"

namespace clast {
namespace {

/// Fewer forms make no surface.
constexpr std::size_t kFewestForms = 6;

/// Names of blocks that `clast vary` stretched end with both ratios: "B01_il0.8_sl0.5".
bool is_stretched(const std::string& name) {
  const std::size_t at = name.rfind("_il");
  return at != std::string::npos && name.find("_sl", at) != std::string::npos;
}

/// A value of a run, and its unit.
struct RunValues {
  std::string outcome, unit;
  std::map<std::string, std::vector<double>> of_form;
};

std::vector<RunValues> values_of_forms(const Comparison& comparison, std::uint32_t file) {
  std::vector<RunValues> values = {
      {"runout", "m", {}}, {"lateral angle", "rad", {}}, {"largest energy", "J", {}}};
  std::vector<std::size_t> lines;
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    const BarrierLine& barrier = comparison.lines[line];
    if (std::count(barrier.files.begin(), barrier.files.end(), file) == 0) continue;
    lines.push_back(line);
    values.push_back({"passing " + barrier.name, "", {}});
  }
  std::vector<std::vector<bool>> passed(lines.size(),
                                        std::vector<bool>(comparison.rows.size(), false));
  for (const CrossingRow& crossing : comparison.crossings) {
    const auto at = std::find(lines.begin(), lines.end(), crossing.barrier);
    if (crossing.counted && at != lines.end()) {
      passed[static_cast<std::size_t>(at - lines.begin())][crossing.row] = true;
    }
  }
  for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
    const RunRow& row = comparison.rows[i];
    if (row.file != file) continue;
    const std::string& form = row.block->library_block();
    const double speed = row.record->result.max_speed;
    values[0].of_form[form].push_back(row.runout);
    values[1].of_form[form].push_back(row.lateral);
    values[2].of_form[form].push_back(0.5 * row.block->mass * speed * speed);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      values[3 + k].of_form[form].push_back(passed[k][i] ? 1.0 : 0.0);
    }
  }
  return values;
}

}  // namespace

std::vector<OutcomeOfForms> outcomes_of_forms(const Comparison& comparison) {
  std::vector<OutcomeOfForms> outcomes;
  for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
    if (comparison.results[file].stay) continue;
    std::map<std::string, Axes> axes;
    for (const BlockSummary& block : comparison.results[file].blocks) {
      axes.emplace(block.library_block(), block.axes);
    }
    for (const RunValues& values : values_of_forms(comparison, file)) {
      if (values.of_form.size() < kFewestForms) continue;
      OutcomeOfForms outcome{file, values.outcome, values.unit, {}};
      for (const auto& [name, all] : values.of_form) {
        const Summary summary = summarise(all);
        outcome.forms.push_back(
            {name, axes.at(name), is_stretched(name), summary.count, summary.mean, summary.std});
      }
      outcomes.push_back(std::move(outcome));
    }
  }
  return outcomes;
}

}  // namespace clast
