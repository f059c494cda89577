#pragma once
/// Texts on the agreement of observed and simulated stops.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Describes the agreement of observed and simulated stops, one sentence per group. Empty without
/// observed stops.
std::vector<std::string> describe_measured_stops(const Comparison& comparison);

}  // namespace clast
