#pragma once
/// Texts of the variance decomposition.
#include <string>
#include <vector>

#include "study/compare/design_effects.hpp"

namespace clast {

/// Describes the variance decomposition of each outcome and file, such as "Form explains 22 % (15
/// to 29) of the runout's variance, ...".
std::vector<std::string> describe_effects(const std::vector<DesignEffects>& effects);

}  // namespace clast
