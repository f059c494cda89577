#pragma once
/// Statistical power of a campaign, estimated before it runs.
#include <cstddef>
#include <optional>

namespace clast {

/// Assumed intraclass correlation of runs of one block: the fraction of the variance that is due to
/// the block.
inline constexpr double kAssumedIntraclassCorrelation = 0.1;
/// Returns the assumed design effect of a comparison of two halves of the blocks: the factor by
/// which correlated runs increase the variance.
/// @cite kish1965
double assumed_design_effect(std::size_t runs, std::size_t blocks);

/// Minimum number of blocks for which the power of comparing two halves is estimated.
inline constexpr std::size_t kMinBlocksForPower = 4;

/// Planned power: smallest detectable runout difference between two halves of the blocks.
struct PlannedPower {
  std::size_t runs = 0, blocks = 0;
  std::size_t trial_runs = 0;  ///< number of trial runs from which `runout_deviation` was estimated
  double runout_deviation = 0.0;  ///< standard deviation of the trial runouts, m
  std::optional<double> margin;   ///< equivalence margin: smallest relevant difference in runout, m

  /// True if there are enough blocks and trial runs to estimate the power.
  bool is_known() const;
  double design_effect() const { return assumed_design_effect(runs, blocks); }
  /// Returns the smallest difference in runout that is detected with 80 % power, m.
  double detectable_difference() const;
  /// Returns the number of runs needed to detect a difference of `margin` with 80 % power.
  double runs_needed() const;
};

}  // namespace clast
