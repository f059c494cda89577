#pragma once
/// The figures of what blocks that stay leave behind, over the realisations of each file, and how
/// far the files differ. Realisations are independent of each other, so a figure has as many values
/// as there are realisations with a deposit.
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/mean_intervals.hpp"
#include "study/compare/realisation_deposits.hpp"

namespace clast {

/// A figure of a realisation.
struct DepositQuantity {
  std::string name;  ///< with its unit: "toe_distance_m"
  std::string unit;  ///< "m"; empty for counts and shares
  std::string words;
  int decimals = 2;                                        ///< that are worth printing
  std::function<double(const DepositMeasures&)> value;  ///< not finite: there is none
  Interval possible = {-INFINITY, INFINITY};
};
/// Blocks at rest, volume, centre of mass, crest to toe, area, bulk volume, thickness.
const std::vector<DepositQuantity>& deposit_quantities();

/// A figure over the realisations of a file.
struct DepositQuantitySummary {
  std::uint32_t file = 0;  ///< index into Comparison::results
  std::size_t figure = 0;  ///< index into `deposit_quantities`
  Summary summary;         ///< its count is that of realisations with the figure
  double least = NAN;
  std::optional<Interval> interval;  ///< 95 %, of the mean; as `mean_interval`
};

/// A figure of one file less that of another, as `welch_difference`; corrected for all that are
/// tested.
struct DepositQuantityDifference : Contrast {
  DepositQuantitySummary first;
  DepositQuantitySummary second;
};

struct DepositQuantityComparison {
  std::vector<DepositQuantitySummary> files;  ///< by file, then figure; figures without a value left out
  /// Of each pair of files, in the order of figures; none with more than `kMostGroups` files.
  std::vector<DepositQuantityDifference> differences;
};
DepositQuantityComparison compare_deposit_quantities(const std::vector<DepositMeasures>& realisations);

}  // namespace clast
