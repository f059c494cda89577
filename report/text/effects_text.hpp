#pragma once
/// Texts of the variance decomposition.
#include <string>
#include <vector>

#include "study/compare/design_effects.hpp"

namespace clast {

/// Describes the effects on each outcome of each file, runout first, such as "Form explains 22 %
/// (15 to 29) of the runout's variance, ...". If a file has no effects, the reason is stated. If
/// fractions are estimated, the reason for it precedes them.
std::vector<std::string> describe_effects(const std::vector<DesignEffects>& effects);

}  // namespace clast
