#pragma once
/// Decomposition of the variance of outcomes into contributions of block shape, mass, release
/// orientation, release point and ground draw. It is exact for full factorial designs and estimated
/// otherwise.
#include <cstdint>
#include <string>
#include <vector>

#include "core/statistics/variance_decomposition.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// Factor of the design with at least two levels.
struct DesignFactor {
  std::string name;  ///< "form", "mass", "block", "orientation", "release point", "ground"
  std::size_t levels = 0;
};

struct OutcomeEffects {
  /// Outcome: "runout", "lateral angle", "largest energy" (translational), or "passing BARRIER".
  std::string outcome;
  std::string unit;              ///< "m", "rad", "J"; empty for a proportion of runs
  double mean = 0.0;             ///< mean of all runs
  double deviation = 0.0;        ///< standard deviation of the runs
  VarianceDecomposition shares;  ///< factors in the order of `DesignEffects::factors`
};

struct DesignEffects {
  std::uint32_t file = 0;
  std::string refusal_reason;  ///< reason why no effects were computed; empty otherwise
  /// Reason why the fractions of variance are estimated by a mixed model. Empty for a full
  /// factorial design; otherwise, `design_fraction` is NaN.
  std::string estimated;
  std::vector<DesignFactor> factors;
  std::vector<OutcomeEffects> outcomes;
};

/// Computes the design effects of each file. The factors for blocks are "form" and "mass" if each
/// library block occurs with each mass (to 0.5 %). The factor is "form" if all blocks have the same
/// mass, and "block" otherwise. Fractions are estimated (core/statistics/unbalanced_variance.hpp)
/// if combinations are missing or repeated, or if orientations are drawn for each release point.
/// Campaigns with persistent blocks, or with a single level of every factor, have no effects;
/// `refusal` gives the reason. Runs that left the terrain are included with their last position.
std::vector<DesignEffects> compute_design_effects(const Comparison& comparison);

}  // namespace clast
