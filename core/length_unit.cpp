#include "core/length_unit.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

double parse_length_unit(const std::string& text) {
  for (const NamedUnit& unit : kLengthUnits) {
    if (text == unit.name) return unit.factor;
  }
  const std::optional<double> factor = parse_number(text);
  if (factor && kLengthUnitRange.contains(*factor)) return *factor;
  throw InputError("`units`: \"" + text +
                   "\" is not a length unit; expected m, cm, mm, um, km, in, ft or the length of "
                   "one unit in metres, a number " +
                   kLengthUnitRange.describe());
}

}  // namespace clast
