#include "study/campaign/value_formats.hpp"

#include <algorithm>

#include "study/campaign/campaign_ranges.hpp"

namespace clast::study_detail {

ValueFormat point() { return list(number(kMapCoordinateRange), 2, 3); }

ValueFormat with_unit(ValueFormat form, const char* unit) {
  ValueFormat* leaf = &form;
  while (!leaf->items.empty()) leaf = &leaf->items.front();
  if (*leaf->range.unit == '\0') leaf->range.unit = unit;
  return form;
}

ValueFormat uncertain(const NumberRange& range) {
  const auto law = [](const char* name, const char* meaning, ValueFormat values) {
    return table({{name, "", meaning, required("two numbers", std::move(values))}});
  };
  const ValueFormat spread = number({0.0, std::max(range.high, kLogSigma.high)});
  return either({number(range), law("uniform", "[low, high]", list(number(range), 2, 2)),
                 law("normal", "[mean, standard deviation]", list(spread, 2, 2)),
                 law("log_normal", "[median, standard deviation of the natural logarithm]",
                     list(spread, 2, 2))});
}

}  // namespace clast::study_detail
