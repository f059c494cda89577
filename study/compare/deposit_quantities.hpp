#pragma once
/// Deposit quantities over the realisations of each file, and their differences between files.
/// Realisations are independent, so each realisation with a deposit gives one value.
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/mean_intervals.hpp"
#include "study/compare/realisation_deposits.hpp"

namespace clast {

/// Quantity of a deposit, such as its area.
struct DepositQuantity {
  std::string name;  ///< with unit, such as "toe_distance_m"
  std::string unit;  ///< such as "m"; empty for counts and fractions
  std::string phrase;
  int decimals = 2;                                     ///< number of printed decimals
  std::function<double(const DepositMeasures&)> value;  ///< not finite if undefined
  Interval possible_range = {-INFINITY, INFINITY};
};
/// Returns all deposit quantities, such as volume, centre of mass, area and thickness.
const std::vector<DepositQuantity>& deposit_quantities();

/// One deposit quantity over the realisations of one file.
struct DepositQuantitySummary {
  std::uint32_t file = 0;    ///< index into Comparison::results
  std::size_t quantity = 0;  ///< index into `deposit_quantities`
  Summary summary;           ///< over the realisations with a value
  double minimum = NAN;
  std::optional<Interval> interval;  ///< 95 % interval of the mean (`mean_interval`)
};

/// Difference of a deposit quantity between two files (`welch_difference`). Its p-value is
/// corrected for the number of tests.
struct DepositQuantityDifference : Contrast {
  DepositQuantitySummary first;
  DepositQuantitySummary second;
};

/// Deposit quantities of all files and their differences.
struct DepositQuantityComparison {
  std::vector<DepositQuantitySummary>
      files;  ///< ordered by file, then quantity; quantities without a value are omitted
  /// Differences of each pair of files, ordered by quantity; empty above `kMaxComparedGroups`
  /// files.
  std::vector<DepositQuantityDifference> differences;
};
/// Summarises the deposit quantities by file and compares all pairs of files.
DepositQuantityComparison compare_deposit_quantities(
    const std::vector<DepositMeasures>& realisations);

}  // namespace clast
