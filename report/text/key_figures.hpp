#pragma once
/// The large numbers of a first screen.
#include <string>
#include <vector>

#include "study/compare/answer.hpp"

namespace clast {

/// One of them.
struct KeyFigure {
  std::string value;      ///< "45 / 32 m"
  std::string label;      ///< "mean runout, compact / elongated"
  std::string range;      ///< "42 to 48 / 30 to 34"; empty: none
  std::string more = {};  ///< "half stop before 44 / 31 m"; empty: none
};

/// Four at most.
std::vector<KeyFigure> key_figures(const Comparison& comparison, const KeyResults& answer);

}  // namespace clast
