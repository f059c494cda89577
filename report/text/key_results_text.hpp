#pragma once
/// Texts of the key results of a comparison. They are equal on page, terminal and summary.
#include <string>
#include <vector>

#include "study/compare/key_results.hpp"

namespace clast {

/// Describes the key results of a comparison in one or two sentences per file.
std::vector<std::string> describe_key_results(const Comparison& comparison,
                                              const KeyResults& answer);

/// Describes the runs of a comparison, such as "192 runs of 3 blocks (330 to 580 kg) in 2 shape
/// classes".
std::string describe_runs(const Comparison& comparison);

/// Describes the intervals of the key results: "Ranges in brackets are 95 % intervals, from 16
/// release points."
std::string describe_intervals(const KeyResults& answer);

/// Describes the limits of validity of the results, such as "Not run: blocks above 580 kg, other
/// ground."
std::string describe_validity_limits(const Comparison& comparison, const KeyResults& answer);

/// Describes key results and warnings of a comparison as lines of plain text.
std::vector<std::string> describe_results_and_warnings(const Comparison& comparison,
                                                       const KeyResults& answer);

}  // namespace clast
