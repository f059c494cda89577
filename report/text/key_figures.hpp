#pragma once
/// Key figures shown at the beginning of a page.
#include <string>
#include <vector>

#include "study/compare/key_results.hpp"

namespace clast {

struct KeyFigure {
  std::string value;  ///< value as text, such as "45 / 32 m"
  std::string label;  ///< meaning of the value, such as "mean runout, compact / elongated"
  std::string range;  ///< range, such as "42 to 48 / 30 to 34"; may be empty
  /// Further information, such as "half stop before 44 / 31 m"; may be empty.
  std::string more = {};
};

std::vector<KeyFigure> select_key_figures(const Comparison& comparison, const KeyResults& answer);

}  // namespace clast
