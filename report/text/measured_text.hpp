#pragma once
/// Texts on the agreement of observed and simulated stops.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// Describes the agreement in one sentence per group. Empty if there are no observed stops.
std::vector<std::string> describe_measured_stops(const Comparison& comparison);

}  // namespace clast
