#pragma once
/// What runs of a results file came to, as one list of values for each outcome.
#include <cstdint>
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast::study_detail {

/// Values of all runs of a file, in their order.
struct RunOutcome {
  std::string name;  ///< "runout", "lateral angle", "largest energy", or "passing BARRIER"
  std::string unit;  ///< "m", "rad", "J"; empty: 1 for a run that passed, else 0
  std::vector<double> values;
};

std::vector<const RunRow*> select_rows_of_file(const Comparison& comparison, std::uint32_t file);

/// A run counts where it ended, also if it left the terrain. The runout is first.
/// @param rows  of the file
std::vector<RunOutcome> collect_run_outcomes(const Comparison& comparison, std::uint32_t file,
                                     const std::vector<const RunRow*>& rows);

/// The masses of the blocks that fell, in rising order, each more than 0.5 % above the one before.
std::vector<double> find_distinct_masses(const std::vector<const RunRow*>& rows);
/// Which of them a mass is: the number of those not above it.
std::size_t find_mass_level(const std::vector<double>& masses, double mass);

}  // namespace clast::study_detail
