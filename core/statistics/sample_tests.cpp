#include "core/statistics/sample_tests.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/random.hpp"
#include "core/statistics/probability.hpp"

namespace clast {
namespace {

constexpr double kMostCells = 1e7;      // of the lattice that the exact test walks
constexpr std::size_t kMaxOrders = 9;   // 9! = 362,880 orders
constexpr double kSmallExpected = 5.0;  // Cochran's rule

/// The pooled samples: after how many values, in ascending order, a value's ties end, and the
/// largest |i n - j m| at such places, which is m n D in whole numbers.
struct Pooled {
  std::vector<bool> ends;  ///< [k - 1] after k values
  std::int64_t distance = 0;
};

Pooled pooled(std::span<const double> a, std::span<const double> b) {
  std::vector<double> x(a.begin(), a.end()), y(b.begin(), b.end());
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  const auto m = static_cast<std::int64_t>(x.size());
  const auto n = static_cast<std::int64_t>(y.size());
  Pooled result;
  result.ends.assign(x.size() + y.size(), false);
  std::size_t i = 0, j = 0;
  while (i < x.size() || j < y.size()) {
    const double value = j == y.size() || (i < x.size() && x[i] <= y[j]) ? x[i] : y[j];
    while (i < x.size() && x[i] == value) ++i;
    while (j < y.size() && y[j] == value) ++j;
    result.ends[i + j - 1] = true;
    result.distance = std::max(result.distance, std::abs(static_cast<std::int64_t>(i) * n -
                                                         static_cast<std::int64_t>(j) * m));
  }
  return result;
}

/// The chance that a random lattice path from (0, 0) to (m, n) is somewhere, at the end of a tie,
/// at least `distance` off the diagonal. Summing what leaves keeps all digits of a small chance.
double chance_of_leaving(std::size_t m, std::size_t n, const Pooled& all) {
  std::vector<double> row(n + 1, 0.0);  // chance to be at (i, j) and never to have left
  double left = 0.0;
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      double here = i == 0 && j == 0 ? 1.0 : 0.0;
      const double steps_left = static_cast<double>(m + n - i - j + 1);
      if (i > 0) here += row[j] * static_cast<double>(m - i + 1) / steps_left;
      if (j > 0) here += row[j - 1] * static_cast<double>(n - j + 1) / steps_left;
      const std::int64_t off = static_cast<std::int64_t>(i * n) - static_cast<std::int64_t>(j * m);
      if (i + j > 0 && all.ends[i + j - 1] && std::abs(off) >= all.distance) {
        left += here;
        here = 0.0;
      }
      row[j] = here;
    }
  }
  return left;
}

/// Pearson's correlation; none when one of the two does not vary.
std::optional<double> pearson_correlation(std::span<const double> x, std::span<const double> y) {
  const double n = static_cast<double>(x.size());
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (xx == 0.0 || yy == 0.0) return std::nullopt;
  return std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
}

/// Share of all orders of `y` whose correlation with `x` is at least as far from zero.
double share_of_orders(std::span<const double> x, std::span<const double> y, double found) {
  std::vector<std::size_t> order(y.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> turned(y.size());
  std::size_t orders = 0, as_far = 0;
  do {
    for (std::size_t i = 0; i < order.size(); ++i) turned[i] = y[order[i]];
    ++orders;
    // Equal correlations differ by the rounding of their sums.
    as_far += std::abs(*pearson_correlation(x, turned)) >= std::abs(found) - 1e-9;
  } while (std::next_permutation(order.begin(), order.end()));
  return static_cast<double>(as_far) / static_cast<double>(orders);
}

double log_factorial(std::size_t n) { return std::lgamma(static_cast<double>(n) + 1.0); }

/// Hypergeometric distribution: number of `marked` balls among `drawn` ones out of `total`. Terms
/// are summed outwards from the most probable number, so that only the spread limits them.
std::size_t drawn_marked(Random& random, std::size_t total, std::size_t marked, std::size_t drawn) {
  const std::size_t low = drawn + marked > total ? drawn + marked - total : 0;
  const std::size_t high = std::min(marked, drawn);
  if (low == high) return low;
  const double N = static_cast<double>(total), K = static_cast<double>(marked),
               n = static_cast<double>(drawn);
  const double peak = std::floor((n + 1.0) * (K + 1.0) / (N + 2.0));
  const std::size_t mode = std::clamp(static_cast<std::size_t>(peak), low, high);
  const double at_mode =
      std::exp(log_factorial(marked) + log_factorial(total - marked) + log_factorial(drawn) +
               log_factorial(total - drawn) - log_factorial(total) - log_factorial(mode) -
               log_factorial(marked - mode) - log_factorial(drawn - mode) -
               log_factorial(total + mode - marked - drawn));
  double rest = random.uniform() - at_mode;
  std::size_t below = mode, above = mode;
  double p_below = at_mode, p_above = at_mode;
  while (rest > 0.0 && (below > low || above < high)) {
    if (above < high) {
      const double k = static_cast<double>(above);
      p_above *= (K - k) * (n - k) / ((k + 1.0) * (N - K - n + k + 1.0));
      ++above;
      rest -= p_above;
      if (rest <= 0.0) return above;
    }
    if (below > low) {
      const double k = static_cast<double>(below);
      p_below *= k * (N - K - n + k) / ((K - k + 1.0) * (n - k + 1.0));
      --below;
      rest -= p_below;
      if (rest <= 0.0) return below;
    }
    // The remainder is the rounding error of a sum that should be one.
    if (p_above + p_below < std::numeric_limits<double>::min()) break;
  }
  return mode;
}

struct ClassTable {
  std::vector<std::size_t> a;      ///< first sample
  std::vector<std::size_t> total;  ///< both
  std::size_t size_a = 0;
  std::size_t size = 0;
};

double chi_squared_statistic(const ClassTable& table) {
  const double size = static_cast<double>(table.size), size_a = static_cast<double>(table.size_a);
  double sum = 0.0;
  for (std::size_t k = 0; k < table.a.size(); ++k) {
    const double total = static_cast<double>(table.total[k]);
    const double expected = total * size_a / size;
    const double miss = static_cast<double>(table.a[k]) - expected;
    sum += miss * miss / expected + miss * miss / (total - expected);
  }
  return sum;
}

/// Deals the pooled blocks anew to two samples of the same sizes.
void shuffle(ClassTable& table, Random& random) {
  std::size_t left = table.size, left_a = table.size_a;
  for (std::size_t k = 0; k < table.a.size(); ++k) {
    table.a[k] = drawn_marked(random, left, table.total[k], left_a);
    left -= table.total[k];
    left_a -= table.a[k];
  }
}

}  // namespace

std::optional<TestResult> two_sample_ks_test(std::span<const double> a, std::span<const double> b) {
  if (a.empty() || b.empty()) return std::nullopt;
  const Pooled all = pooled(a, b);
  const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
  TestResult result;
  result.statistic = static_cast<double>(all.distance) / (m * n);
  if (all.distance == 0) return result;
  result.exact = m * n <= kMostCells;
  result.p_value = result.exact
                       ? std::min(1.0, chance_of_leaving(a.size(), b.size(), all))
                       : kolmogorov_upper_tail(result.statistic * std::sqrt(m * n / (m + n)));
  return result;
}

std::vector<double> fractional_ranks(std::span<const double> values) {
  // Values beside their places: sorting places alone would look all over the memory.
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) order.emplace_back(values[i], i);
  std::sort(order.begin(), order.end());
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    while (end < order.size() && order[end].first == order[i].first) ++end;
    const double shared = 0.5 * static_cast<double>(i + 1 + end);
    for (; i < end; ++i) result[order[i].second] = shared;
  }
  return result;
}

std::optional<TestResult> spearman_test(std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size());
  if (x.size() < 3) return std::nullopt;
  const std::vector<double> rank_x = fractional_ranks(x), rank_y = fractional_ranks(y);
  const std::optional<double> found = pearson_correlation(rank_x, rank_y);
  if (!found) return std::nullopt;
  TestResult result;
  result.statistic = *found;
  result.exact = x.size() <= kMaxOrders;
  if (result.exact) {
    result.p_value = share_of_orders(rank_x, rank_y, *found);
  } else {
    const double degrees_of_freedom = static_cast<double>(x.size()) - 2.0;
    result.p_value = student_two_sided_tail(
        *found * std::sqrt(degrees_of_freedom / (1.0 - *found * *found)), degrees_of_freedom);
  }
  return result;
}

std::optional<ChiSquaredResult> chi_squared_test(std::span<const std::size_t> a,
                                                 std::span<const std::size_t> b, std::uint64_t seed,
                                                 std::size_t draws) {
  assert(a.size() == b.size() && draws > 0);
  ClassTable table;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] + b[k] == 0) continue;
    table.a.push_back(a[k]);
    table.total.push_back(a[k] + b[k]);
    table.size_a += a[k];
    table.size += a[k] + b[k];
  }
  if (table.size_a == 0 || table.size_a == table.size || table.a.size() < 2) return std::nullopt;

  ChiSquaredResult test;
  test.chi_squared = chi_squared_statistic(table);
  test.degrees_of_freedom = table.a.size() - 1;
  test.smallest_expected =
      static_cast<double>(*std::min_element(table.total.begin(), table.total.end())) *
      static_cast<double>(std::min(table.size_a, table.size - table.size_a)) /
      static_cast<double>(table.size);
  if (test.smallest_expected >= kSmallExpected) {
    test.p_value =
        chi_squared_upper_tail(test.chi_squared, static_cast<double>(test.degrees_of_freedom));
    return test;
  }
  test.draws = draws;
  Random random(seed);
  std::size_t as_extreme = 0;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    shuffle(table, random);
    as_extreme += chi_squared_statistic(table) >= test.chi_squared * (1.0 - 1e-9);
  }
  test.p_value = static_cast<double>(1 + as_extreme) / static_cast<double>(1 + draws);
  return test;
}

}  // namespace clast
