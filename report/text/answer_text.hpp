#pragma once
/// The answer of a comparison in words: the same on the page, on the terminal and in the summary.
#include <string>
#include <vector>

#include "study/compare/answer.hpp"

namespace clast {

/// A sentence or two for each statement.
std::vector<std::string> describe_key_results(const Comparison& comparison, const KeyResults& answer);

/// "192 runs of 3 blocks (330 to 580 kg) in 2 shape classes"
std::string describe_runs(const Comparison& comparison);

/// What the intervals rest on: "Ranges in brackets are 95 % intervals, from 16 release points."
std::string describe_intervals(const KeyResults& answer);

/// What the answer does not speak of: "Not run: blocks above 580 kg, other ground."
std::string describe_limits(const Comparison& comparison, const KeyResults& answer);

/// The first screen as lines of plain text, cautions included.
std::vector<std::string> describe_first_screen(const Comparison& comparison, const KeyResults& answer);

}  // namespace clast
