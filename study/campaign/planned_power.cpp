#include "study/campaign/planned_power.hpp"

#include <cmath>

#include "core/statistics/crossed_difference.hpp"

namespace clast {

double assumed_design_effect(std::size_t runs, std::size_t blocks) {
  const double each = static_cast<double>(runs) / static_cast<double>(blocks);
  return 1.0 + (each - 1.0) * kAssumedIntraclassCorrelation;
}

bool PlannedPower::is_known() const {
  return trial_runs > 1 && blocks >= kMinBlocksForPower && runout_deviation > 0.0;
}

double PlannedPower::detectable_difference() const {
  // Values needed go with one over the square of the difference.
  return std::sqrt(required_sample_size(1.0, runout_deviation, design_effect()) /
                   static_cast<double>(runs));
}

double PlannedPower::runs_needed() const {
  const double times = detectable_difference() / *margin;
  return std::ceil(times * times * static_cast<double>(runs));
}

}  // namespace clast
