#pragma once
/// Statistics of deposit quantities over the realisations of each file, and differences between
/// files.
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/mean_intervals.hpp"
#include "study/compare/realisation_deposits.hpp"

namespace clast {

/// Declaration of a quantity of a deposit, such as its area.
struct DepositQuantity {
  std::string name;  ///< name with unit, such as "toe_distance_m"
  std::string unit;  ///< unit; empty for counts and fractions
  std::string phrase;
  int decimals = 2;  ///< number of printed decimals
  /// Function that returns the value; not finite if undefined.
  std::function<double(const DepositMeasures&)> value;
  Interval possible_range = {-INFINITY, INFINITY};
};
/// Returns all deposit quantities, such as volume, centre of mass, area and thickness.
const std::vector<DepositQuantity>& deposit_quantities();

/// Statistics of one deposit quantity over the realisations of one file.
struct DepositQuantitySummary {
  std::uint32_t file = 0;    ///< index into Comparison::results
  std::size_t quantity = 0;  ///< index into `deposit_quantities`
  SampleSummary summary;     ///< statistics of the realisations with a value
  double minimum = NAN;
  std::optional<Interval> interval;  ///< 95 % confidence interval of the mean
};

/// Difference of a deposit quantity between two files, with a test.
struct DepositQuantityDifference : Contrast {
  DepositQuantitySummary first;
  DepositQuantitySummary second;
};

/// Deposit quantities of all files and their differences.
struct DepositQuantityComparison {
  /// Statistics ordered by file, then quantity; quantities without a value are omitted.
  std::vector<DepositQuantitySummary> files;
  /// Differences of each pair of files; empty if there are more than `kMaxComparedGroups` files.
  std::vector<DepositQuantityDifference> differences;
};
/// Summarises the deposit quantities by file and compares all pairs of files.
DepositQuantityComparison compare_deposit_quantities(
    const std::vector<DepositMeasures>& realisations);

}  // namespace clast
