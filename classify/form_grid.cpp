#include "classify/form_grid.hpp"

#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

void check_grid(int steps, double min_ratio) {
  if (steps < 1 || steps > 100) {
    throw InputError("a grid of " + std::to_string(steps) + " steps: must be from 1 to 100");
  }
  if (!(min_ratio > 0.0 && min_ratio < 1.0)) {
    throw InputError("`least` = " + format_significant(min_ratio, 4) +
                     ": must be above 0 and below 1");
  }
}

}  // namespace

std::vector<Axes> sneed_folk_grid(int steps, double min_ratio) {
  check_grid(steps, min_ratio);
  std::vector<Axes> forms;
  for (int row = 0; row <= steps; ++row) {
    const double S = 1.0 - (1.0 - min_ratio) * row / steps;
    for (int k = 0; k <= row; ++k) {
      const double elongated = row == 0 ? 0.0 : static_cast<double>(k) / row;
      forms.push_back({1.0, k == row && row > 0 ? S : 1.0 - elongated * (1.0 - S), S});
    }
  }
  return forms;
}

std::vector<Axes> zingg_grid(int steps, double min_ratio) {
  check_grid(steps, min_ratio);
  std::vector<Axes> forms;
  for (int i = 0; i <= steps; ++i) {
    const double I = min_ratio + (1.0 - min_ratio) * i / steps;
    for (int k = 0; k <= steps; ++k) {
      forms.push_back({1.0, I, k == steps ? I : I * (min_ratio + (1.0 - min_ratio) * k / steps)});
    }
  }
  return forms;
}

}  // namespace clast
