#include "classify/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace clast {
namespace {

/// Order of the entries by value.
std::vector<std::size_t> sorted_order(std::span<const double> sample) {
  std::vector<std::size_t> order(sample.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sample[a] < sample[b]; });
  return order;
}

std::vector<double> ranks(std::span<const double> sample) {
  const std::vector<std::size_t> order = sorted_order(sample);
  std::vector<double> rank(sample.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last + 1 < order.size() && sample[order[last + 1]] == sample[order[first]]) ++last;
    for (std::size_t i = first; i <= last; ++i) {
      rank[order[i]] = 0.5 * static_cast<double>(first + last);
    }
    first = last + 1;
  }
  return rank;
}

/// Probability that Kolmogorov's limit distribution exceeds `lambda`.
double kolmogorov_tail(double lambda) {
  // Below this the sum is 1 to double precision and converges slowly.
  if (lambda < 0.2) return 1.0;
  double sum = 0.0;
  for (int k = 1; k <= 100; ++k) {
    const double term = std::exp(-2.0 * k * k * lambda * lambda);
    sum += k % 2 ? term : -term;
    if (term < 1e-17) break;
  }
  return std::clamp(2.0 * sum, 0.0, 1.0);
}

/// Upper regularised incomplete gamma function Q(a, x): its series for small x, else its continued
/// fraction by Lentz's method.
double gamma_tail(double a, double x) {
  if (!(x > 0.0)) return 1.0;
  const double scale = std::exp(-x + a * std::log(x) - std::lgamma(a));
  if (x < a + 1.0) {
    double term = 1.0 / a, sum = term;
    for (int n = 1; n < 10000 && term > 1e-17 * sum; ++n) sum += term *= x / (a + n);
    return std::max(0.0, 1.0 - sum * scale);
  }
  constexpr double kTiny = 1e-300;
  double b = x + 1.0 - a, c = 1.0 / kTiny, d = 1.0 / b, h = d;
  for (int i = 1; i < 10000; ++i) {
    const double an = -i * (i - a);
    b += 2.0;
    d = an * d + b;
    d = 1.0 / (std::abs(d) < kTiny ? kTiny : d);
    c = b + an / c;
    c = std::abs(c) < kTiny ? kTiny : c;
    h *= d * c;
    if (std::abs(d * c - 1.0) < 1e-15) break;
  }
  return scale * h;
}

}  // namespace

double quantile(std::vector<double> sample, double share) {
  std::sort(sample.begin(), sample.end());
  const double place = share * static_cast<double>(sample.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sample.size()) return sample.back();
  const double part = place - static_cast<double>(below);
  return (1.0 - part) * sample[below] + part * sample[below + 1];
}

double weighted_quantile(std::span<const double> sample, std::span<const double> weights,
                         double share) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  double below = 0.0, previous_place = 0.0, previous_value = 0.0;
  bool first = true;
  for (const std::size_t i : sorted_order(sample)) {
    const double place = (below + 0.5 * weights[i]) / total;
    if (place >= share) {
      if (first || !(place > previous_place)) return sample[i];
      const double part = (share - previous_place) / (place - previous_place);
      return (1.0 - part) * previous_value + part * sample[i];
    }
    below += weights[i];
    previous_place = place;
    previous_value = sample[i];
    first = false;
  }
  return previous_value;
}

double rank_correlation(std::span<const double> x, std::span<const double> y) {
  const std::vector<double> a = ranks(x), b = ranks(y);
  const double middle = 0.5 * static_cast<double>(a.size() - 1);
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    xx += (a[i] - middle) * (a[i] - middle);
    yy += (b[i] - middle) * (b[i] - middle);
    xy += (a[i] - middle) * (b[i] - middle);
  }
  return xx > 0.0 && yy > 0.0 ? xy / std::sqrt(xx * yy) : 0.0;
}

TestResult kolmogorov_smirnov(std::vector<double> a, std::vector<double> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  const auto n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
  TestResult result;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double value = std::min(a[i], b[j]);
    while (i < a.size() && a[i] <= value) ++i;
    while (j < b.size() && b[j] <= value) ++j;
    result.statistic = std::max(result.statistic,
                                std::abs(static_cast<double>(i) / n - static_cast<double>(j) / m));
  }
  const double root = std::sqrt(n * m / (n + m));
  result.p_value = kolmogorov_tail((root + 0.12 + 0.11 / root) * result.statistic);
  return result;
}

TestResult chi_squared(std::span<const std::size_t> a, std::span<const std::size_t> b) {
  const auto sum = [](std::span<const std::size_t> row) {
    return static_cast<double>(std::accumulate(row.begin(), row.end(), std::size_t{0}));
  };
  const double in_a = sum(a), in_b = sum(b), total = in_a + in_b;
  TestResult result;
  std::size_t classes = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto both = static_cast<double>(a[i] + b[i]);
    if (both == 0.0) continue;
    ++classes;
    const double expected_a = both * in_a / total, expected_b = both * in_b / total;
    const double off = static_cast<double>(a[i]) - expected_a;
    result.statistic += off * off * (1.0 / expected_a + 1.0 / expected_b);
    result.small_counts = result.small_counts || std::min(expected_a, expected_b) < 5.0;
  }
  if (classes < 2) return {};
  result.degrees = classes - 1;
  result.p_value = gamma_tail(0.5 * static_cast<double>(result.degrees), 0.5 * result.statistic);
  return result;
}

}  // namespace clast
