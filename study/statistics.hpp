#pragma once
/// Small statistics on samples.
#include <cstddef>
#include <span>

namespace clast {

/// Of a sample; all zero when it is empty.
struct Summary {
  std::size_t count = 0;
  double mean = 0.0;
  double std = 0.0;     ///< sample standard deviation (n - 1); 0 for one value
  double median = 0.0;
  double p95 = 0.0;     ///< linear between order statistics (Hyndman & Fan type 7)
  double max = 0.0;
};

Summary summarise(std::span<const double> values);

}  // namespace clast
