#pragma once
/// Axis ranges, and histogram bins with round edges.
#include <cstddef>
#include <vector>

namespace clast::report_detail {

/// Range of an axis, not empty.
struct AxisInterval {
  double low = 0.0;
  double high = 1.0;
};

/// Chooses the range of an axis for values from `low` to `high`. It includes zero if zero is close,
/// and is widened if all values are equal.
AxisInterval nice_axis_range(double low, double high);

/// Histogram bins of equal width. A value on an edge belongs to the lower bin.
struct Bins {
  double low = 0.0;
  double width = 1.0;
  std::size_t count = 1;

  /// Returns the index of the bin that contains a value.
  std::size_t bin_index(double value) const;
  double edge(std::size_t bin) const { return low + width * static_cast<double>(bin); }
};

/// Chooses about 24 histogram bins with round edges, or up to 60 so that all `limits` are edges.
Bins choose_bins(const AxisInterval& values, const std::vector<double>& limits = {});

}  // namespace clast::report_detail
