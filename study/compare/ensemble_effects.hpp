#pragma once
/// Effects of uncertain ground parameters on outcomes, estimated over the members of an ensemble.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/statistics/sample_tests.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// Effect of an uncertain ground parameter on an outcome, estimated over the members of an
/// ensemble.
struct ParameterEffect {
  std::uint32_t file = 0;  ///< index of the results file
  std::string group;       ///< name of the block group; empty for blocks that belong to no group
  std::string zone;
  std::string parameter;                       ///< name of a ground parameter, such as "friction"
  std::size_t members = 0;                     ///< number of members with the outcome
  double low = 0.0, median = 0.0, high = 0.0;  ///< minimum, median and maximum of the drawn values
  /// Name of the outcome: mean runout, or fraction of runs that pass a barrier.
  std::string outcome;
  double outcome_p5 = 0.0, outcome_median = 0.0,
         outcome_p95 = 0.0;               ///< percentiles over the members
  std::optional<TestResult> correlation;  ///< Spearman rank correlation; empty below three members
  /// First-order Sobol index; empty if there are too few members.
  std::optional<double> first_order;
};

/// Estimates the first-order Sobol index of `x` for `y`, in [0, 1]: the fraction of the variance of
/// `y` that `x` explains. It is computed from the means of `y` in groups of similar `x`.
/// @param x, y  finite, of equal length
/// @return empty below 40 pairs, or if all x or all y are equal
/// @cite hays1963, plischke2013
std::optional<double> estimate_first_order_index(std::span<const double> x,
                                                 std::span<const double> y);

/// Computes the effects of all uncertain ground parameters, ordered by file, block group and
/// outcome.
std::vector<ParameterEffect> compute_ensemble_effects(const Comparison& comparison);

/// Returns the number of ensemble members of a campaign; 1 without an ensemble.
std::uint32_t count_ensemble_members(const CampaignResults& results);

}  // namespace clast
