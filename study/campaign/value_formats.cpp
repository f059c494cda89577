#include "study/campaign/value_formats.hpp"

#include <algorithm>

#include "study/campaign/campaign_ranges.hpp"

namespace clast::study_detail {

ValueFormat point_format() { return list_format(number_format(kMapCoordinateRange), 2, 3); }

ValueFormat with_unit(ValueFormat form, const char* unit) {
  ValueFormat* innermost_format = &form;
  while (!innermost_format->items.empty()) innermost_format = &innermost_format->items.front();
  if (*innermost_format->range.unit == '\0') innermost_format->range.unit = unit;
  return form;
}

ValueFormat uncertain_number_format(const NumberRange& range) {
  const auto law = [](const char* name, const char* meaning, ValueFormat values) {
    return table_format({{name, "", meaning, required_format("two numbers", std::move(values))}});
  };
  const ValueFormat spread = number_format({0.0, std::max(range.high, kLogSigmaRange.high)});
  return alternative_formats(
      {number_format(range), law("uniform", "[low, high]", list_format(number_format(range), 2, 2)),
       law("normal", "[mean, standard deviation]", list_format(spread, 2, 2)),
       law("log_normal", "[median, standard deviation of the natural logarithm]",
           list_format(spread, 2, 2))});
}

}  // namespace clast::study_detail
