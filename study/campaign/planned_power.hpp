#pragma once
/// Statistical power of a campaign, estimated before it runs.
#include <cstddef>
#include <optional>

namespace clast {

/// Assumed intraclass correlation: the fraction of the variance due to the block itself, so that
/// runs of one block are not independent.
inline constexpr double kAssumedBlockFraction = 0.1;
/// Returns the design effect for comparing two halves of the blocks: 1 + (runs per block - 1)
/// kAssumedBlockFraction. @cite kish1965
double assume_design_effect(std::size_t runs, std::size_t blocks);

/// Minimum number of blocks for a comparison of halves.
inline constexpr std::size_t kMinBlocksOfPower = 4;

/// Planned power: the runout difference between two halves of the blocks that a campaign can
/// detect.
struct PlannedPower {
  std::size_t runs = 0, blocks = 0;
  std::size_t trial_runs = 0;    ///< number of trial runs behind `scatter`
  double scatter = 0.0;          ///< standard deviation of the trial runouts, m
  std::optional<double> margin;  ///< smallest relevant difference, m

  /// True if there are at least four blocks, two trial runs and a positive scatter.
  bool is_known() const;
  double design_effect() const { return assume_design_effect(runs, blocks); }
  double smallest() const;     ///< minimum detectable difference at 80 % power, m
  double runs_needed() const;  ///< to detect `margin`, with proportionally more blocks
};

}  // namespace clast
