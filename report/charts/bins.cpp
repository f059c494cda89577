#include "report/charts/bins.hpp"

#include <algorithm>
#include <cmath>

#include "core/nice_number.hpp"

namespace clast::report_detail {
namespace {

// A value is a hair beside the edge of a bin by rounding alone: 1.3/1.0 - 1 is above 0.3.
constexpr double kOnEdge = 1e-9;  // widths of a bin

bool is_whole_number(double number) { return std::abs(number - std::round(number)) < kOnEdge; }

}  // namespace

AxisInterval nice_axis_range(double low, double high) {
  if (!(low <= high)) return {};
  // An axis that nearly reaches zero is read as if it did: let it.
  if (low > 0.0 && low < 0.5 * high) low = 0.0;
  // Values that are equal to rounding get a width, so that ticks and bins stay countable.
  const double size = std::max(std::abs(low), std::abs(high));
  if (high - low <= 1e-9 * size || low == high) {
    const double margin = std::max(0.5, 1e-6 * size);
    return {low - margin, high + margin};
  }
  return {low, high};
}

std::size_t Bins::bin_index(double value) const {
  const double place = std::ceil((value - low) / width - kOnEdge) - 1.0;
  return std::min(static_cast<std::size_t>(std::max(place, 0.0)), count - 1);
}

Bins choose_bins(const AxisInterval& values, const std::vector<double>& limits) {
  constexpr double kUsual = 24.0, kMost = 60.0;
  Bins bins;
  bins.width = round_up_to_nice_number((values.high - values.low) / kUsual);
  const auto fit = [&](double width) {
    return std::all_of(limits.begin(), limits.end(),
                       [&](double limit) { return is_whole_number(limit / width); });
  };
  for (double width = bins.width; (values.high - values.low) / width <= kMost;
       width = round_up_to_nice_number(0.4 * width)) {
    if (!fit(width)) continue;
    bins.width = width;
    break;
  }
  // Nothing is below a zero at the end: it is in the bin above it.
  const double first = values.low == 0.0 ? 0.0 : std::ceil(values.low / bins.width - kOnEdge) - 1.0;
  const double last = std::ceil(values.high / bins.width - kOnEdge);
  bins.low = first * bins.width;
  bins.count = static_cast<std::size_t>(std::max(1.0, last - first));
  return bins;
}

}  // namespace clast::report_detail
