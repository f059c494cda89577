#include "core/statistics/unbalanced_variance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/statistics/probability.hpp"

namespace clast {
namespace {

constexpr std::size_t kMaxGroupings = 6;
constexpr std::uint32_t kMaxGroups = 40;  ///< of levels that are left out together
constexpr std::size_t kMinTrimmed = 5;    ///< levels; with fewer nothing is left to trim
constexpr double kOffset = 0.01;          ///< of shares, so that zero has odds
constexpr double kUpperQuantile = 0.975;

/// Group of each value.
struct Grouping {
  std::vector<std::uint32_t> of_value;
  std::uint32_t count = 0;
  bool interaction = false;
};

/// The same with groups numbered from zero without gaps.
Grouping numbered(const std::vector<std::uint64_t>& keys, bool interaction) {
  std::vector<std::uint64_t> known = keys;
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  Grouping grouping{{}, static_cast<std::uint32_t>(known.size()), interaction};
  for (const std::uint64_t key : keys) {
    grouping.of_value.push_back(static_cast<std::uint32_t>(
        std::lower_bound(known.begin(), known.end(), key) - known.begin()));
  }
  return grouping;
}

/// Factors, pairs of factors that are neither single values nor one of the factors, and values.
std::vector<Grouping> groupings_of(std::span<const std::vector<std::uint32_t>> factors) {
  const std::size_t values = factors.front().size();
  std::vector<Grouping> groupings;
  for (const std::vector<std::uint32_t>& factor : factors) {
    groupings.push_back(numbered({factor.begin(), factor.end()}, false));
  }
  const std::size_t alone = groupings.size();
  for (std::size_t a = 0; a < alone; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      std::vector<std::uint64_t> keys;
      for (std::size_t i = 0; i < values; ++i) {
        keys.push_back(std::uint64_t{groupings[a].of_value[i]} << 32 | groupings[b].of_value[i]);
      }
      Grouping pair = numbered(keys, true);
      const bool nested = pair.count == groupings[a].count || pair.count == groupings[b].count;
      if (!nested && pair.count < values) groupings.push_back(std::move(pair));
    }
  }
  std::vector<std::uint64_t> each(values);
  std::iota(each.begin(), each.end(), std::uint64_t{0});
  groupings.push_back(numbered(each, true));
  return groupings;
}

/// The groups of the values that are kept.
struct CachedAnalysis {
  const std::vector<Grouping>& groupings;
  std::vector<std::uint32_t> values;  ///< by number

  std::vector<double> sizes(std::size_t grouping) const {
    std::vector<double> sizes(groupings[grouping].count, 0.0);
    for (const std::uint32_t i : values) sizes[groupings[grouping].of_value[i]] += 1.0;
    return sizes;
  }
};

/// Expected sums of squares for unit variance components: traces of (M V_i M V_j), where M removes
/// the mean and V_i marks values of the same group.
Eigen::MatrixXd expectations(const CachedAnalysis& kept) {
  const std::size_t count = kept.groupings.size();
  const auto n = static_cast<double>(kept.values.size());
  std::vector<std::vector<double>> sizes;
  std::vector<double> squares;
  for (std::size_t i = 0; i < count; ++i) {
    sizes.push_back(kept.sizes(i));
    squares.push_back(std::inner_product(sizes[i].begin(), sizes[i].end(), sizes[i].begin(), 0.0));
  }
  Eigen::MatrixXd expected(count, count);
  std::vector<std::uint64_t> keys(kept.values.size());
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const Grouping &first = kept.groupings[i], &second = kept.groupings[j];
      for (std::size_t k = 0; k < keys.size(); ++k) {
        const std::uint32_t value = kept.values[k];
        keys[k] = std::uint64_t{first.of_value[value]} << 32 | second.of_value[value];
      }
      std::sort(keys.begin(), keys.end());
      double shared = 0.0, crossed = 0.0;
      for (std::size_t k = 0; k < keys.size();) {
        const std::uint64_t key = keys[k];
        double both = 0.0;
        for (; k < keys.size() && keys[k] == key; ++k) both += 1.0;
        shared += both * both;
        crossed += both * sizes[i][key >> 32] * sizes[j][key & 0xffffffffu];
      }
      expected(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          expected(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) =
              shared - 2.0 / n * crossed + squares[i] * squares[j] / (n * n);
    }
  }
  return expected;
}

/// Components of the variance of the values that are kept, none below zero.
std::vector<double> unbalanced_components(
    const CachedAnalysis& kept,
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>& solver,
    const std::vector<double>& values) {
  double mean = 0.0;
  for (const std::uint32_t i : kept.values) {
    mean += values[i] / static_cast<double>(kept.values.size());
  }
  Eigen::VectorXd squares(static_cast<Eigen::Index>(kept.groupings.size()));
  for (std::size_t g = 0; g < kept.groupings.size(); ++g) {
    std::vector<double> sums(kept.groupings[g].count, 0.0);
    for (const std::uint32_t i : kept.values) {
      sums[kept.groupings[g].of_value[i]] += values[i] - mean;
    }
    squares[static_cast<Eigen::Index>(g)] =
        std::inner_product(sums.begin(), sums.end(), sums.begin(), 0.0);
  }
  const Eigen::VectorXd solved = solver.solve(squares);
  std::vector<double> components;
  for (const double component : solved) components.push_back(std::max(0.0, component));
  return components;
}

/// Shares of the factors, then that of all interactions.
std::vector<double> grouping_shares(const std::vector<Grouping>& groupings,
                                    const std::vector<double>& components, std::size_t factors) {
  std::vector<double> shares(factors + 1, 0.0);
  const double total = std::accumulate(components.begin(), components.end(), 0.0);
  if (!(total > 0.0)) return shares;
  for (std::size_t g = 0; g < groupings.size(); ++g) {
    shares[groupings[g].interaction ? factors : g] += components[g] / total;
  }
  return shares;
}

double log_odds(double share) { return std::log((share + kOffset) / (1.0 - share + kOffset)); }

double share_of_log_odds(double z) {
  const double odds = std::exp(z);
  return std::clamp((odds * (1.0 + kOffset) - kOffset) / (1.0 + odds), 0.0, 1.0);
}

/// Shares of all outcomes, of the values that are kept.
std::vector<std::vector<double>> all_shares(const CachedAnalysis& kept, std::size_t factors,
                                            std::span<const std::vector<double>> outcomes,
                                            std::vector<double>* variances = nullptr) {
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(expectations(kept));
  std::vector<std::vector<double>> shares;
  for (const std::vector<double>& values : outcomes) {
    const std::vector<double> components = unbalanced_components(kept, solver, values);
    shares.push_back(grouping_shares(kept.groupings, components, factors));
    if (variances) {
      variances->push_back(std::accumulate(components.begin(), components.end(), 0.0));
    }
  }
  return shares;
}

/// Mean of the values of each level, ascending.
std::vector<double> level_means(const Grouping& factor, const std::vector<double>& values) {
  std::vector<double> sums(factor.count, 0.0), sizes(factor.count, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    sums[factor.of_value[i]] += values[i];
    sizes[factor.of_value[i]] += 1.0;
  }
  for (std::size_t level = 0; level < sums.size(); ++level) sums[level] /= sizes[level];
  std::sort(sums.begin(), sums.end());
  return sums;
}

/// Correction of the jackknife variance for skewed effects of a factor: the variance of a variance
/// depends on the kurtosis minus (k - 3)/k; the kurtosis of few levels is underestimated about
/// their mean and nearly unbiased about their trimmed mean. @cite bonett2006
double skew_factor(const std::vector<double>& means) {
  if (means.size() <= kMinTrimmed) return 1.0;
  const auto count = static_cast<double>(means.size());
  const auto cut = static_cast<std::size_t>(count / (2.0 * std::sqrt(count - 4.0)));
  const double mean = arithmetic_mean(means);
  const double trimmed = arithmetic_mean(std::span(means).subspan(cut, means.size() - 2 * cut));
  double squares = 0.0, about_mean = 0.0, about_trimmed = 0.0;
  for (const double value : means) {
    squares += std::pow(value - mean, 2);
    about_mean += std::pow(value - mean, 4);
    about_trimmed += std::pow(value - trimmed, 4);
  }
  if (!(squares > 0.0)) return 1.0;
  const double to_kurtosis = count / (squares * squares), normal = (count - 3.0) / count;
  return std::max(1.0,
                  (about_trimmed * to_kurtosis - normal) / (about_mean * to_kurtosis - normal));
}

/// Variance of the logarithm of the odds of a share, summed over factors.
struct Scatter {
  double variance = 0.0;
  double over_freedom = 0.0;  ///< sum of squared variances over their degrees of freedom

  /// @param factor  as `skew_factor`
  void add(const std::vector<double>& tried, double factor) {
    const auto count = static_cast<double>(tried.size());
    const double mean = std::accumulate(tried.begin(), tried.end(), 0.0) / count;
    double squares = 0.0;
    for (const double value : tried) squares += (value - mean) * (value - mean);
    const double part = factor * (count - 1.0) / count * squares;
    variance += part;
    over_freedom += part * part / (count - 1.0);
  }
  Interval around(double share) const {
    if (!(variance > 0.0)) return {share, share};
    const double degrees_of_freedom = std::max(1.0, variance * variance / over_freedom);
    const double half = student_quantile(kUpperQuantile, degrees_of_freedom) * std::sqrt(variance);
    const double middle = log_odds(share);
    return {std::min(share, share_of_log_odds(middle - half)),
            std::max(share, share_of_log_odds(middle + half))};
  }
};

void check_lists(std::span<const std::vector<double>> outcomes,
                 std::span<const std::vector<std::uint32_t>> factors) {
  if (factors.empty() || factors.size() > kMaxGroupings) {
    throw InputError(std::to_string(factors.size()) + " factors; give one to six");
  }
  const std::size_t count = factors.front().size();
  for (const std::vector<std::uint32_t>& factor : factors) {
    if (factor.size() != count) throw InputError("factors of different lengths");
    if (std::equal(factor.begin() + 1, factor.end(), factor.begin())) {
      throw InputError("a factor of one level explains no variance");
    }
  }
  for (const std::vector<double>& values : outcomes) {
    if (values.size() != count) {
      throw InputError(std::to_string(values.size()) + " values with the levels of " +
                       std::to_string(count));
    }
  }
}

}  // namespace

std::vector<VarianceDecomposition> decompose_unbalanced_variance(
    std::span<const std::vector<double>> outcomes,
    std::span<const std::vector<std::uint32_t>> factors) {
  check_lists(outcomes, factors);
  const std::vector<Grouping> groupings = groupings_of(factors);
  const std::size_t count = factors.front().size(), shown = factors.size() + 1;
  CachedAnalysis all{groupings, std::vector<std::uint32_t>(count)};
  std::iota(all.values.begin(), all.values.end(), 0u);
  std::vector<double> variances;
  const auto estimates = all_shares(all, factors.size(), outcomes, &variances);
  std::vector<std::vector<Scatter>> scatters(outcomes.size(), std::vector<Scatter>(shown));
  for (std::size_t f = 0; f < factors.size(); ++f) {
    if (groupings[f].count < 3) continue;
    const std::uint32_t groups = std::min(kMaxGroups, groupings[f].count);
    std::vector<std::vector<std::vector<double>>> tried(outcomes.size(),
                                                        std::vector<std::vector<double>>(shown));
    for (std::uint32_t group = 0; group < groups; ++group) {
      CachedAnalysis kept{groupings, {}};
      for (std::uint32_t i = 0; i < count; ++i) {
        if (groupings[f].of_value[i] % groups != group) kept.values.push_back(i);
      }
      const auto without = all_shares(kept, factors.size(), outcomes);
      for (std::size_t o = 0; o < outcomes.size(); ++o) {
        for (std::size_t s = 0; s < shown; ++s) tried[o][s].push_back(log_odds(without[o][s]));
      }
    }
    for (std::size_t o = 0; o < outcomes.size(); ++o) {
      const double factor = skew_factor(level_means(groupings[f], outcomes[o]));
      for (std::size_t s = 0; s < shown; ++s) scatters[o][s].add(tried[o][s], factor);
    }
  }
  std::vector<VarianceDecomposition> result(outcomes.size());
  for (std::size_t o = 0; o < outcomes.size(); ++o) {
    result[o].variance = variances[o];
    for (std::size_t s = 0; s < shown; ++s) {
      VarianceFraction share{std::numeric_limits<double>::quiet_NaN(), estimates[o][s],
                             scatters[o][s].around(estimates[o][s])};
      if (s < factors.size() && groupings[s].count < 3 && variances[o] > 0.0) {
        share.interval = {0.0, 1.0};
      }
      if (s < factors.size()) {
        result[o].factors.push_back(share);
      } else {
        result[o].interactions = share;
      }
    }
  }
  return result;
}

}  // namespace clast
