#pragma once
/// Continuous shape measures of block populations.
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "classify/form.hpp"

namespace clast {

/// Continuous shape measure with its name and formula.
struct ShapeMeasure {
  const char* name;     ///< column name
  const char* formula;  ///< formula as shown to users
  std::optional<double> (*value)(const Axes&);
};

/// Returns the measures s_c = L/I - 1, q = S/L and d = (L - I)/(L - S). d is undefined for L = S.
const std::array<ShapeMeasure, 3>& shape_measures();

/// Returns the values of a shape measure, rounded by `round_ratio`. Blocks without a value are
/// omitted.
std::vector<double> measure_values(const ShapeMeasure& measure, std::span<const Axes> blocks);

/// Rounds a ratio to 1e-12. Equal ratios, such as 1.1/0.8 and 0.55/0.4, then compare equal.
double round_ratio(double ratio);

}  // namespace clast
