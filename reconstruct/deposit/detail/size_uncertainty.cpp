#include "reconstruct/deposit/detail/size_uncertainty.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace clast::reconstruct_detail {

namespace {

/// Range of ln(estimate / truth).
struct LogRatioRange {
  double low, high;
};

/// Ranges of V, L, I and S at one visible fraction.
struct QuantileRow {
  double visible_fraction;
  std::array<LogRatioRange, 4> ranges;
};

/// Quantiles 5 and 95 %.
constexpr std::array<QuantileRow, 6> kIntervals = {{
    {0.30, {{{-0.15, 1.60}, {-0.15, 0.76}, {-0.13, 0.53}, {-0.32, 0.50}}}},
    {0.45, {{{-0.36, 0.49}, {-0.15, 0.24}, {-0.21, 0.23}, {-0.27, 0.26}}}},
    {0.55, {{{-0.35, 0.32}, {-0.13, 0.19}, {-0.15, 0.13}, {-0.27, 0.19}}}},
    {0.65, {{{-0.28, 0.14}, {-0.10, 0.12}, {-0.20, 0.09}, {-0.23, 0.10}}}},
    {0.75, {{{-0.17, 0.08}, {-0.10, 0.09}, {-0.12, 0.08}, {-0.19, 0.08}}}},
    {0.90, {{{-0.10, 0.04}, {-0.06, 0.08}, {-0.13, 0.03}, {-0.11, 0.05}}}},
}};
/// Bounds beyond the quantiles 0.5 and 99.5 %.
constexpr std::array<QuantileRow, 4> kBounds = {{
    {0.30, {{{-1.0, 3.3}, {-0.40, 2.10}, {-0.60, 1.20}, {-0.70, 1.00}}}},
    {0.50, {{{-1.0, 1.0}, {-0.45, 0.60}, {-0.45, 0.40}, {-0.60, 0.60}}}},
    {0.70, {{{-0.9, 0.4}, {-0.40, 0.30}, {-0.45, 0.30}, {-0.60, 0.30}}}},
    {0.90, {{{-0.8, 0.15}, {-0.30, 0.18}, {-0.30, 0.15}, {-0.45, 0.15}}}},
}};
constexpr double kHalfVisible = 0.5;

template <std::size_t kRows>
LogRatioRange interpolate_range(const std::array<QuantileRow, kRows>& rows, double visible_fraction,
                                std::size_t quantity) {
  const double v =
      std::clamp(visible_fraction, rows.front().visible_fraction, rows.back().visible_fraction);
  std::size_t k = 1;
  while (k + 1 < kRows && v > rows[k].visible_fraction) ++k;
  const QuantileRow &a = rows[k - 1], &b = rows[k];
  const double t = (v - a.visible_fraction) / (b.visible_fraction - a.visible_fraction);
  const LogRatioRange &ra = a.ranges[quantity], &rb = b.ranges[quantity];
  return {ra.low + t * (rb.low - ra.low), ra.high + t * (rb.high - ra.high)};
}

template <std::size_t kRows>
SizeIntervals sizes_within(const std::array<QuantileRow, kRows>& rows, double volume,
                           const Vec3& sides, double visible_fraction) {
  const LogRatioRange v = interpolate_range(rows, visible_fraction, 0);
  SizeIntervals sizes{volume * std::exp(-v.high), volume * std::exp(-v.low), {}};
  for (int k = 0; k < 3; ++k) {
    const LogRatioRange r =
        interpolate_range(rows, visible_fraction, static_cast<std::size_t>(k) + 1);
    sizes.sides.lower[k] = sides[k] * std::exp(-r.high);
    sizes.sides.upper[k] = sides[k] * std::exp(-r.low);
  }
  return sizes;
}

}  // namespace

VolumeBracket estimate_size_uncertainty(double volume, const Vec3& sides, double visible_fraction) {
  const SizeIntervals bounds = sizes_within(kBounds, volume, sides, visible_fraction);
  VolumeBracket bracket{.lower_volume = bounds.lower_volume, .estimated_volume = volume};
  if (visible_fraction >= kHalfVisible) bracket.upper_volume = bounds.upper_volume;
  bracket.sides = bounds.sides;
  bracket.intervals = sizes_within(kIntervals, volume, sides, visible_fraction);
  bracket.filled_fraction = 1.0 - visible_fraction;
  bracket.assumption = "the hidden side is like that of blocks of virtual deposits";
  return bracket;
}

}  // namespace clast::reconstruct_detail
