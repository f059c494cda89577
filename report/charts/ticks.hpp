#pragma once
/// Round numbers for axes.
#include <cstddef>
#include <vector>

namespace clast::report_detail {

struct Ticks {
  double step = 1.0;
  int decimals = 0;            ///< that distinguish neighbouring ticks
  std::vector<double> values;  ///< multiples of step inside [low, high], ascending
};

/// Multiples of 1, 2 or 5 times a power of ten inside [low, high], about `wanted` of them.
Ticks ticks(double low, double high, int wanted);

/// Multiples of 1, 2 and 5 of powers of ten inside [low, high]; of 1 alone where there would be
/// more than `most`.
/// @param low, high  positive
std::vector<double> choose_log_ticks(double low, double high, std::size_t most);

}  // namespace clast::report_detail
