#pragma once
/// Axis ticks at round numbers.
#include <cstddef>
#include <vector>

namespace clast::report_detail {

struct AxisTicks {
  double step = 1.0;
  int decimals = 0;            ///< number of decimals that distinguish neighbouring ticks
  std::vector<double> values;  ///< multiples of `step` inside [low, high], ascending
};

/// Chooses about `wanted` axis ticks in [low, high] with a step of 1, 2 or 5 times a power of ten.
AxisTicks choose_ticks(double low, double high, int wanted);

/// Chooses ticks at 1, 2 and 5 times powers of ten in [low, high]. If there would be more than
/// `most` ticks, only powers of ten are used.
/// @param low, high  positive
std::vector<double> choose_log_ticks(double low, double high, std::size_t maximum);

}  // namespace clast::report_detail
