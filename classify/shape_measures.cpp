#include "classify/shape_measures.hpp"

#include <cmath>

namespace clast {

const std::array<ShapeMeasure, 3>& shape_measures() {
  static const std::array<ShapeMeasure, 3> measures = {
      {{"s_c", "L/I - 1", [](const Axes& axes) { return std::optional(elongation_index(axes)); }},
       {"q", "S/L", [](const Axes& axes) { return std::optional(axes.S / axes.L); }},
       {"d", "(L - I)/(L - S)", [](const Axes& axes) { return disc_rod_index(axes); }}}};
  return measures;
}

double round_ratio(double ratio) { return std::round(ratio * 1e12) * 1e-12; }

std::vector<double> measure_values(const ShapeMeasure& measure, std::span<const Axes> blocks) {
  std::vector<double> values;
  values.reserve(blocks.size());
  for (const Axes& axes : blocks) {
    if (const auto value = measure.value(axes)) values.push_back(round_ratio(*value));
  }
  return values;
}

}  // namespace clast
