#pragma once
/// How observed stops agree with simulated ones, in words: on the page, on the terminal and in the
/// summary.
#include <string>
#include <vector>

#include "study/compare/comparison.hpp"

namespace clast {

/// A sentence for each group of observed stops; none without observed stops.
std::vector<std::string> describe_measured_stops(const Comparison& comparison);

}  // namespace clast
