#pragma once
/// Texts of the variance decomposition.
#include <string>
#include <vector>

#include "study/compare/design_effects.hpp"

namespace clast {

/// Describes each outcome of each file, runout first: "Form explains 22 % (15 to 29) of the
/// runout's variance, ..."; or why a file has no effects. Estimated fractions are preceded by their
/// reason.
std::vector<std::string> describe_effects(const std::vector<DesignEffects>& effects);

}  // namespace clast
