#pragma once
/// Axes and bins with round edges, for every chart of a distribution.
#include <cstddef>
#include <vector>

namespace clast::report_detail {

/// From low to high, never without width.
struct Span {
  double low = 0.0;
  double high = 1.0;
};

/// The span of an axis over values from `low` to `high`: from zero on where it would nearly reach
/// it, and with a width where all values are equal to rounding. [0, 1] when low > high: no values.
Span nice_axis_range(double low, double high);

/// Bins of one width. A value on an edge is in the bin below it, as classes are: up to a limit.
struct Bins {
  double low = 0.0;
  double width = 1.0;
  std::size_t count = 1;

  std::size_t of(double value) const;  ///< below `count`
  double edge(std::size_t bin) const { return low + width * static_cast<double>(bin); }
};

/// About two dozen bins with round edges; up to five dozen where limits are on edges only then.
Bins bins_of(const Span& values, const std::vector<double>& limits = {});

}  // namespace clast::report_detail
