#pragma once
/// What the variance of outcomes is due to, in words.
#include <string>
#include <vector>

#include "study/compare/design_effects.hpp"

namespace clast {

/// A sentence for each outcome of each file, the runout first: "Form explains 22 % (15 to 29) of
/// the runout's variance, ..."; or why a file has none. Before
/// those that are estimated, what is missing.
std::vector<std::string> describe_effects(const std::vector<DesignEffects>& effects);

}  // namespace clast
