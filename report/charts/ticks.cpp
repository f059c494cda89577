#include "report/charts/ticks.hpp"

#include <algorithm>
#include <cmath>

#include "core/nice_number.hpp"

namespace clast::report_detail {

AxisTicks choose_ticks(double low, double high, int wanted) {
  AxisTicks found;
  // Narrower than rounding can count through: one tick.
  const double size = std::max(std::abs(low), std::abs(high));
  if (!(high - low > 1e-9 * size) || !std::isfinite(high - low)) {
    found.values = {low};
    return found;
  }
  found.step = round_up_to_nice_number((high - low) / std::max(wanted, 1));
  found.decimals = std::max(0, -static_cast<int>(std::floor(std::log10(found.step) + 1e-9)));
  // A hair of slack keeps a tick that rounding put just outside.
  const double slack = 1e-9 * found.step;
  for (double k = std::ceil((low - slack) / found.step); k * found.step <= high + slack; k += 1.0) {
    found.values.push_back(k == 0.0 ? 0.0 : k * found.step);
  }
  return found;
}

std::vector<double> choose_log_ticks(double low, double high, std::size_t maximum) {
  std::vector<double> all, decades;
  for (double power = std::pow(10.0, std::floor(std::log10(low))); power <= high * (1.0 + 1e-9);
       power *= 10.0) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * power;
      if (value < low * (1.0 - 1e-9) || value > high * (1.0 + 1e-9)) continue;
      all.push_back(value);
      if (factor == 1.0) decades.push_back(value);
    }
  }
  return all.size() <= maximum ? all : decades;
}

}  // namespace clast::report_detail
