#include "classify/sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "classify/statistics.hpp"

namespace clast {
namespace {

/// Largest distance between the counted distribution of sorted sizes and a fitted one.
template <class Distribution>
double largest_distance(const std::vector<double>& sorted, const Distribution& share_below) {
  const auto n = static_cast<double>(sorted.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double fitted = share_below(sorted[i]);
    largest = std::max({largest, std::abs(fitted - static_cast<double>(i) / n),
                        std::abs(fitted - static_cast<double>(i + 1) / n)});
  }
  return largest;
}

SizeFit log_normal_fit(const std::vector<double>& sorted) {
  const auto n = static_cast<double>(sorted.size());
  double mean = 0.0, square = 0.0;
  for (const double d : sorted) mean += std::log(d) / n;
  for (const double d : sorted) square += (std::log(d) - mean) * (std::log(d) - mean) / n;
  SizeFit fit{std::exp(mean), std::sqrt(square), 0.0};
  fit.distance = largest_distance(sorted, [&](double d) {
    return 0.5 * std::erfc(-(std::log(d) - mean) / (fit.spread * std::sqrt(2.0)));
  });
  return fit;
}

/// The likelihood is greatest where g(n) = sum x^n ln x / sum x^n - 1/n - mean ln x is 0; g rises
/// with n. Sizes are taken relative to the largest, so that no power overflows.
SizeFit rosin_rammler_fit(const std::vector<double>& sorted) {
  const auto count = static_cast<double>(sorted.size());
  const double largest = sorted.back();
  double mean = 0.0;
  for (const double d : sorted) mean += std::log(d / largest) / count;
  const auto powers = [&](double n) {
    double sum = 0.0, with_log = 0.0;
    for (const double d : sorted) {
      const double log = std::log(d / largest), power = std::exp(n * log);
      sum += power;
      with_log += power * log;
    }
    return std::array{sum, with_log};
  };
  double low = 1e-3, high = 1e6;
  for (int i = 0; i < 200 && high > low * (1.0 + 1e-15); ++i) {
    const double n = std::sqrt(low * high);
    const auto [sum, with_log] = powers(n);
    (with_log / sum - 1.0 / n - mean < 0.0 ? low : high) = n;
  }
  SizeFit fit{0.0, std::sqrt(low * high), 0.0};
  fit.scale = largest * std::pow(powers(fit.spread)[0] / count, 1.0 / fit.spread);
  fit.distance = largest_distance(
      sorted, [&](double d) { return -std::expm1(-std::pow(d / fit.scale, fit.spread)); });
  return fit;
}

std::optional<double> s_over_l(const Axes& axes) { return axes.S / axes.L; }

}  // namespace

double nominal_diameter(const Axes& axes) { return std::cbrt(axes.L * axes.I * axes.S); }

SizeDistribution size_distribution(std::span<const Axes> blocks, std::span<const double> masses) {
  std::vector<double> sizes;
  for (const Axes& axes : blocks) sizes.push_back(nominal_diameter(axes));
  SizeDistribution result;
  result.d10 = quantile(sizes, 0.1);
  result.d50 = quantile(sizes, 0.5);
  result.d90 = quantile(sizes, 0.9);
  if (!masses.empty()) {
    result.mass_d10 = weighted_quantile(sizes, masses, 0.1);
    result.mass_d50 = weighted_quantile(sizes, masses, 0.5);
    result.mass_d90 = weighted_quantile(sizes, masses, 0.9);
  }
  std::sort(sizes.begin(), sizes.end());
  if (sizes.back() > sizes.front()) {
    result.log_normal = log_normal_fit(sizes);
    result.rosin_rammler = rosin_rammler_fit(sizes);
  }
  return result;
}

std::optional<SizeAndShape> size_and_shape(std::span<const Axes> blocks) {
  if (blocks.size() < 3) return std::nullopt;
  const auto correlation = [&](const auto& index) {
    std::vector<double> sizes, values;
    for (const Axes& axes : blocks) {
      const std::optional<double> value = index(axes);
      if (!value) continue;
      sizes.push_back(nominal_diameter(axes));
      values.push_back(*value);
    }
    return sizes.empty() ? 0.0 : rank_correlation(sizes, values);
  };
  return SizeAndShape{correlation(elongation_s_c), correlation(s_over_l),
                      correlation(disc_rod_index)};
}

}  // namespace clast
