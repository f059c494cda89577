#pragma once
/// Outcomes of the runs of a results file, such as runout and largest energy.
#include <cstdint>
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast::study_detail {

/// Values of one outcome for all runs of a file.
struct RunOutcome {
  std::string name;  ///< name, such as "runout" or "largest energy"
  std::string unit;  ///< unit; empty for the passing of a barrier, whose values are 1 or 0
  std::vector<double> values;
};

std::vector<const RunRow*> select_rows_of_file(const Comparison& comparison, std::uint32_t file);

/// Collects the outcomes of the runs of a file, runout first.
/// @param rows  runs of the file
std::vector<RunOutcome> collect_run_outcomes(const Comparison& comparison, std::uint32_t file,
                                             const std::vector<const RunRow*>& rows);

/// Finds the distinct block masses, in ascending order. Masses that differ by less than 0.5 % count
/// as equal.
std::vector<double> find_distinct_masses(const std::vector<const RunRow*>& rows);
/// Returns the index of a block mass in the list of distinct masses.
std::size_t find_mass_level(const std::vector<double>& masses, double mass);

}  // namespace clast::study_detail
