#pragma once
/// The answer of a comparison in words: the same on the page, on the terminal and in the summary.
#include <string>
#include <vector>

#include "study/compare/answer.hpp"

namespace clast {

/// A sentence or two for each statement.
std::vector<std::string> answer_sentences(const Comparison& comparison, const Answer& answer);

/// "192 runs of 3 blocks (330 to 580 kg) in 2 shape classes"
std::string runs_in_words(const Comparison& comparison);

/// What the intervals rest on: "Ranges in brackets are 95 % intervals, from 16 release points."
std::string intervals_in_words(const Answer& answer);

/// What the answer does not speak of: "Not run: blocks above 580 kg, other ground."
std::string limits_in_words(const Comparison& comparison, const Answer& answer);

/// The first screen as lines of plain text, cautions included.
std::vector<std::string> first_screen(const Comparison& comparison, const Answer& answer);

}  // namespace clast
