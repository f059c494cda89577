#pragma once
/// Statistical power of a campaign, estimated before it runs.
#include <cstddef>
#include <optional>

namespace clast {

/// Assumed intraclass correlation: the fraction of the variance that is due to the block. Because
/// of it, runs of one block are not independent.
inline constexpr double kAssumedIntraclassCorrelation = 0.1;
/// Returns the design effect of a comparison of two halves of the blocks: 1 + (runs per block - 1)
/// kAssumedIntraclassCorrelation.
/// @cite kish1965
double assumed_design_effect(std::size_t runs, std::size_t blocks);

/// Minimum number of blocks for which two halves are compared.
inline constexpr std::size_t kMinBlocksForPower = 4;

/// Planned power: smallest detectable runout difference between two halves of the blocks.
struct PlannedPower {
  std::size_t runs = 0, blocks = 0;
  std::size_t trial_runs = 0;     ///< number of trial runs from which `scatter` was estimated
  double runout_deviation = 0.0;  ///< standard deviation of the trial runouts, m
  std::optional<double> margin;   ///< smallest relevant difference in runout, m

  /// True if there are at least four blocks, two trial runs and a positive scatter.
  bool is_known() const;
  double design_effect() const { return assumed_design_effect(runs, blocks); }
  double detectable_difference() const;  ///< minimum detectable difference at 80 % power, m
  double runs_needed() const;  ///< number of runs needed to detect `margin`, if the number of
                               ///< blocks grows in proportion
};

}  // namespace clast
