#pragma once
/// Verdicts counted, as a table in Markdown.
#include <string>
#include <vector>

#include "tests/app/reliability/judge.hpp"

namespace clast::reliability {

/// One case of the trial.
struct Judged {
  std::string kind;
  std::string level;  ///< amount and unit
  std::string name;   ///< of the case
  Verdict verdict;
};

/// A row for each kind, with the sum of all below; with `levels` one for each amount of each kind.
std::string markdown_table(const std::vector<Judged>& judged, bool levels);

}  // namespace clast::reliability
