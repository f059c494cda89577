#include "study/compare/detail/run_outcomes.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace clast::study_detail {
namespace {

/// Masses that differ by less are one.
constexpr double kMassLevelFraction = 5e-3;

}  // namespace

std::vector<const RunRow*> select_rows_of_file(const Comparison& comparison, std::uint32_t file) {
  std::vector<const RunRow*> rows;
  for (const RunRow& row : comparison.rows) {
    if (row.file == file) rows.push_back(&row);
  }
  return rows;
}

std::vector<RunOutcome> collect_run_outcomes(const Comparison& comparison, std::uint32_t file,
                                             const std::vector<const RunRow*>& rows) {
  std::vector<RunOutcome> outcomes = {
      {"runout", "m", {}}, {"lateral angle", "rad", {}}, {"largest energy", "J", {}}};
  for (const RunRow* row : rows) {
    outcomes[0].values.push_back(row->runout);
    outcomes[1].values.push_back(row->lateral);
    const double speed = row->record->result.max_speed;
    outcomes[2].values.push_back(0.5 * row->block->mass * speed * speed);
  }
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    const BarrierLine& barrier = comparison.lines[line];
    if (!barrier.is_in(file)) continue;
    const std::vector<const Crossing*> crossings = find_counted_crossings(comparison, line);
    RunOutcome outcome{"passing " + barrier.name, "", {}};
    for (const RunRow* row : rows) {
      const auto index = static_cast<std::size_t>(row - comparison.rows.data());
      outcome.values.push_back(crossings[index] ? 1.0 : 0.0);
    }
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

std::vector<double> find_distinct_masses(const std::vector<const RunRow*>& rows) {
  std::set<double> all;
  for (const RunRow* row : rows) all.insert(row->block->mass);
  std::vector<double> distinct;
  for (const double mass : all) {
    if (distinct.empty() || mass > distinct.back() * (1.0 + kMassLevelFraction))
      distinct.push_back(mass);
  }
  return distinct;
}

std::size_t find_mass_level(const std::vector<double>& masses, double mass) {
  return static_cast<std::size_t>(std::upper_bound(masses.begin(), masses.end(), mass) -
                                  masses.begin());
}

}  // namespace clast::study_detail
