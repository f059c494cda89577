#pragma once
/// Key figures of a first screen.
#include <string>
#include <vector>

#include "study/compare/key_results.hpp"

namespace clast {

struct KeyFigure {
  std::string value;      ///< "45 / 32 m"
  std::string label;      ///< "mean runout, compact / elongated"
  std::string range;      ///< "42 to 48 / 30 to 34", or empty
  std::string more = {};  ///< "half stop before 44 / 31 m", or empty
};

std::vector<KeyFigure> select_key_figures(const Comparison& comparison, const KeyResults& answer);

}  // namespace clast
