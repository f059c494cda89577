#include "core/nice_number.hpp"

#include <cmath>
#include <initializer_list>

namespace clast {

double round_up_to_nice_number(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (value <= factor * power * (1.0 + 1e-12)) return factor * power;
  }
  return 10.0 * power;
}

double round_down_to_nice_number(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= value) return factor * power;
  }
  return power;
}

}  // namespace clast
