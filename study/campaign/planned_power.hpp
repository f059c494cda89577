#pragma once
/// The difference between shapes that a campaign can find, estimated before it runs.
#include <cstddef>
#include <optional>

namespace clast {

/// What is assumed before a campaign: the share of the variance that goes with the block itself, so
/// that runs of one block are no independent runs.
inline constexpr double kAssumedBlockShare = 0.1;
/// Design effect of the difference of two halves of the blocks: 1 + (runs of a block - 1) times
/// that share. @cite kish1965
double assume_design_effect(std::size_t runs, std::size_t blocks);

/// Blocks whose halves are compared.
inline constexpr std::size_t kFewestBlocksOfPower = 4;

/// What a campaign could tell apart, before it runs: a difference in runout between two halves of
/// its blocks.
struct PlannedPower {
  std::size_t runs = 0, blocks = 0;
  std::size_t trial_runs = 0;    ///< that the scatter is known from
  double scatter = 0.0;          ///< of their runout, standard deviation, m
  std::optional<double> margin;  ///< difference that matters, m

  /// Four blocks, two trial runs and a scatter; else there is nothing to say.
  bool known() const;
  double design_effect() const { return assume_design_effect(runs, blocks); }
  double smallest() const;     ///< difference that is found in 80 % of such campaigns, m
  double runs_needed() const;  ///< of the margin, with as many more blocks
};

}  // namespace clast
