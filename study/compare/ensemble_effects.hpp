#pragma once
/// What uncertain ground does to where blocks go: the outcome of every member of an ensemble, and
/// the drawn parameter that it goes with.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/statistics/sample_tests.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// A drawn ground parameter and an outcome, over the members of an ensemble. Every member has the
/// same blocks, release points and orientations.
struct ParameterEffect {
  std::uint32_t file = 0;  ///< index of the results file
  std::string group;       ///< block group whose runs are meant; empty: blocks in no group
  std::string zone;
  std::string parameter;                       ///< name of a ground field, "friction"
  std::size_t members = 0;                     ///< that have the outcome
  double low = 0.0, median = 0.0, high = 0.0;  ///< of the values drawn
  std::string outcome;  ///< "mean runout", m, of the runs at rest, or "past BARRIER", a share
  double outcome_p5 = 0.0, outcome_median = 0.0, outcome_p95 = 0.0;  ///< over members
  std::optional<TestResult> correlation;  ///< Spearman's; none below three members
  std::optional<double> first_order;      ///< as `estimate_first_order_index`
};

/// The share of the variance of `y` that goes with `x` alone, in [0, 1]: the members in the order
/// of x are cut into groups of equal size; it is the variance of their means, less what chance
/// gives [hays1963].
/// @param x, y  finite, of one length
/// @return none below 40 pairs, or when all x or all y are equal
/// @cite hays1963, plischke2013
std::optional<double> estimate_first_order_index(std::span<const double> x, std::span<const double> y);

/// In order of file, block group, outcome, zone and parameter. Empty without ensembles.
std::vector<ParameterEffect> compute_ensemble_effects(const Comparison& comparison);

/// How often the ground of a campaign was drawn; 1 without an ensemble.
std::uint32_t count_ensemble_members(const CampaignResults& results);

}  // namespace clast
