#pragma once
/// What share of the variance of an outcome is due to the block's form and mass, the orientation at
/// release, the release point and the drawn ground: exactly of campaigns that run every
/// combination, else as an estimate.
#include <cstdint>
#include <string>
#include <vector>

#include "core/statistics/variance_decomposition.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// A factor of the campaign with two levels or more.
struct DesignFactor {
  std::string name;  ///< "form", "mass", "block", "orientation", "release point", "ground"
  std::size_t levels = 0;
};

struct OutcomeEffects {
  /// "runout", "lateral angle", "largest energy" (of the centre's motion), or "passing BARRIER".
  std::string outcome;
  std::string unit;              ///< "m", "rad", "J"; empty: a share of runs
  double mean = 0.0;             ///< over all runs
  double deviation = 0.0;        ///< standard deviation of the runs
  VarianceDecomposition shares;  ///< factors in the order of `DesignEffects::factors`
};

/// Of one results file.
struct DesignEffects {
  std::uint32_t file = 0;
  std::string refusal;  ///< why there are no effects; empty: there are
  /// Not every combination was run once: shares are those of a mixed model, `design_fraction` is
  /// not a number. What is missing; empty: the design is full.
  std::string estimated;
  std::vector<DesignFactor> factors;
  std::vector<OutcomeEffects> outcomes;
};

/// For every file of the comparison. Blocks are form and mass where each block of the library has
/// each mass (to 0.5 %), form alone where all have one mass, and else one factor, "block". Where a
/// combination is missing or comes twice, and where orientations are drawn anew for each point and
/// thus are no factor, shares are estimated (core/statistics/decompose_unbalanced_variance.hpp). A
/// campaign in which blocks stay and one with nothing but one level have no effects, and `refusal`
/// says why. A run counts where it ended, also if it left the terrain.
std::vector<DesignEffects> compute_design_effects(const Comparison& comparison);

}  // namespace clast
