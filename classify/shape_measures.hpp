#pragma once
/// The continuous measures of shape that populations are described and compared by.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "classify/form.hpp"

namespace clast {

struct ShapeMeasure {
  const char* name;     ///< for columns
  const char* formula;  ///< for readers
  std::optional<double> (*value)(const Axes&);
};

/// s_c = L/I - 1, q = S/L and d = (L - I)/(L - S); none is d of L = S.
const std::array<ShapeMeasure, 3>& shape_measures();

/// Values of one measure, rounded to 1e-12: ratios of decimals that are equal on paper, such as
/// 1.1/0.8 and 0.55/0.4, are then ties. Blocks without a value are left out.
std::vector<double> measure_values(const ShapeMeasure& measure, std::span<const Axes> blocks);

/// Rounded as above, so that ties on paper are ties here.
double remove_rounding(double ratio);

}  // namespace clast
