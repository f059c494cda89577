#include "core/statistics/effect_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {
namespace {

double squares_of(std::span<const double> values) {
  const double mean = arithmetic_mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum;
}

}  // namespace

std::optional<double> cliffs_delta(std::span<const double> a, std::span<const double> b) {
  if (a.empty() || b.empty()) return std::nullopt;
  std::vector<double> sorted(b.begin(), b.end());
  std::sort(sorted.begin(), sorted.end());
  double balance = 0.0;
  for (const double value : a) {
    const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), value);
    balance += static_cast<double>(low - sorted.begin()) - static_cast<double>(sorted.end() - high);
  }
  return balance / (static_cast<double>(a.size()) * static_cast<double>(b.size()));
}

const char* describe_cliffs_delta(double delta) {
  const double size = std::abs(delta);
  return size < 0.147 ? "negligible" : size < 0.33 ? "small" : size < 0.474 ? "medium" : "large";
}

std::optional<double> hedges_g(std::span<const double> a, std::span<const double> b) {
  if (a.size() < 2 || b.size() < 2) return std::nullopt;
  const double degrees_of_freedom = static_cast<double>(a.size() + b.size() - 2);
  const double pooled = std::sqrt((squares_of(a) + squares_of(b)) / degrees_of_freedom);
  if (!(pooled > 0.0)) return std::nullopt;
  return (1.0 - 3.0 / (4.0 * degrees_of_freedom - 1.0)) *
         (arithmetic_mean(a) - arithmetic_mean(b)) / pooled;
}

}  // namespace clast
