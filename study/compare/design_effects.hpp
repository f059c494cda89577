#pragma once
/// Decomposition of the variance of outcomes into contributions of block shape, mass, release
/// orientation, release point and ground parameters.
#include <cstdint>
#include <string>
#include <vector>

#include "core/statistics/variance_decomposition.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// Factor of the design of a campaign, with at least two levels.
struct DesignFactor {
  std::string name;  ///< name, such as "form", "mass", "orientation" or "release point"
  std::size_t levels = 0;
};

struct OutcomeEffects {
  /// Name of the outcome, such as "runout" or "largest energy".
  std::string outcome;
  std::string unit;              ///< "m", "rad", "J"; empty for a proportion of runs
  double mean = 0.0;             ///< mean of all runs
  double deviation = 0.0;        ///< standard deviation of the runs
  VarianceDecomposition shares;  ///< fraction of the variance due to each factor
};

struct DesignEffects {
  std::uint32_t file = 0;
  std::string refusal_reason;  ///< reason why no effects were computed; empty otherwise
  /// Reason why the fractions of the variance are estimated. Empty for a full factorial design, for
  /// which they are exact.
  std::string estimated;
  std::vector<DesignFactor> factors;
  std::vector<OutcomeEffects> outcomes;
};

/// Computes the effects of block shape, mass, orientation, release point and ground on the outcomes
/// of each file. They are exact for full factorial designs and estimated otherwise. Campaigns with
/// persistent blocks, or with a single level of every factor, have no effects.
std::vector<DesignEffects> compute_design_effects(const Comparison& comparison);

}  // namespace clast
