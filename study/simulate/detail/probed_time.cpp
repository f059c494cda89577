#include "study/simulate/detail/probed_time.hpp"

#include <algorithm>
#include <cmath>

namespace clast::study_detail {

double estimate_remaining_time(const ProbedState& earlier, const ProbedState& now, double left) {
  const double step = std::max(now.time - earlier.time, 1e-12);
  const double computed = now.computed - earlier.computed;
  if (now.moving >= earlier.moving) return computed * left / step;
  const auto before = static_cast<double>(earlier.moving), after = static_cast<double>(now.moving);
  return computed * after / (before - after) * (1.0 - std::pow(after / before, left / step));
}

}  // namespace clast::study_detail
