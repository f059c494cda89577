#pragma once
/// Outcomes of the runs of a results file, such as runout and largest energy.
#include <cstdint>
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast::study_detail {

/// One outcome of all runs of a file, in the order of the runs.
struct RunOutcome {
  std::string name;  ///< "runout", "lateral angle", "largest energy", or "passing BARRIER"
  std::string unit;  ///< "m", "rad", "J"; empty for an indicator: 1 if the run passed, otherwise 0
  std::vector<double> values;
};

std::vector<const RunRow*> select_rows_of_file(const Comparison& comparison, std::uint32_t file);

/// Collects the outcomes of runs, runout first. Runs off the terrain have their last position.
/// @param rows  runs of the file
std::vector<RunOutcome> collect_run_outcomes(const Comparison& comparison, std::uint32_t file,
                                             const std::vector<const RunRow*>& rows);

/// Returns the distinct block masses in ascending order; those within 0.5 % of the last are merged.
std::vector<double> find_distinct_masses(const std::vector<const RunRow*>& rows);
/// Returns the level of a mass: the number of distinct masses that are not larger.
std::size_t find_mass_level(const std::vector<double>& masses, double mass);

}  // namespace clast::study_detail
