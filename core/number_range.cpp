#include "core/number_range.hpp"

#include "core/number_text.hpp"

namespace clast {

bool NumberRange::contains(double value) const {
  return (value >= low && value <= high) || (zero_meaning && value == 0.0);
}

std::string NumberRange::describe() const {
  std::string text;
  if (zero_meaning) text = *zero_meaning ? "0 (" + std::string(zero_meaning) + "), or " : "0, or ";
  text += "from " + format_significant(low, 6) + " to " + format_significant(high, 6);
  return *unit ? text + " " + unit : text;
}

}  // namespace clast
