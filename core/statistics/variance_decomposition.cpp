#include "core/statistics/variance_decomposition.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

constexpr std::size_t kMaxCrossedFactors = 6;
constexpr std::size_t kDraws = 2000;
constexpr double kLow = 0.025, kHigh = 0.975;

/// A set of factors as bits.
using Subset = std::size_t;

/// Sums of squares of all sets of factors, and what goes with them. The empty set holds zero.
struct Analysis {
  std::vector<double> squares, degrees_of_freedom;
  std::vector<double> others;  ///< combinations of the levels of the factors not in the set
};

/// Means over all factors that are not in the set, by the combination of those in it.
std::vector<double> means_of(Subset set, std::span<const double> values,
                             std::span<const std::size_t> levels) {
  std::size_t cells = 1;
  for (std::size_t f = 0; f < levels.size(); ++f) cells *= set >> f & 1 ? levels[f] : 1;
  std::vector<double> sums(cells, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::size_t rest = i, cell = 0, stride = 1;
    for (std::size_t f = levels.size(); f-- > 0;) {
      const std::size_t level = rest % levels[f];
      rest /= levels[f];
      if (set >> f & 1) {
        cell += stride * level;
        stride *= levels[f];
      }
    }
    sums[cell] += values[i];
  }
  const double each = static_cast<double>(values.size()) / static_cast<double>(cells);
  for (double& sum : sums) sum /= each;
  return sums;
}

Analysis analysis_of(std::span<const double> values, std::span<const std::size_t> levels) {
  const Subset all = (Subset{1} << levels.size()) - 1;
  const auto count = static_cast<double>(values.size());
  std::vector<double> raw(all + 1, 0.0);
  Analysis result{std::vector<double>(all + 1, 0.0), std::vector<double>(all + 1, 0.0),
                  std::vector<double>(all + 1, 1.0)};
  for (Subset set = 1; set <= all; ++set) {
    const std::vector<double> means = means_of(set, values, levels);
    for (const double mean : means) raw[set] += mean * mean;
    raw[set] *= count / static_cast<double>(means.size());
    result.degrees_of_freedom[set] = 1.0;
    for (std::size_t f = 0; f < levels.size(); ++f) {
      (set >> f & 1 ? result.degrees_of_freedom[set] : result.others[set]) *=
          static_cast<double>(levels[f]) - (set >> f & 1 ? 1.0 : 0.0);
    }
    // Variance not explained by the subsets.
    for (Subset part = set; part > 0; part = (part - 1) & set) {
      result.squares[set] +=
          (std::popcount(set) - std::popcount(part)) % 2 == 0 ? raw[part] : -raw[part];
    }
    result.squares[set] = std::max(0.0, result.squares[set]);
  }
  return result;
}

/// Variance components out of mean squares, none below zero.
std::vector<double> balanced_components(const Analysis& analysis,
                                        const std::vector<double>& mean_squares) {
  const Subset all = mean_squares.size() - 1;
  std::vector<double> components(mean_squares.size(), 0.0);
  for (Subset set = 1; set <= all; ++set) {
    for (Subset larger = set; larger <= all; larger = (larger + 1) | set) {
      const bool even = (std::popcount(larger) - std::popcount(set)) % 2 == 0;
      components[set] += even ? mean_squares[larger] : -mean_squares[larger];
    }
    components[set] = std::max(0.0, components[set] / analysis.others[set]);
  }
  return components;
}

/// Shares of the factors, then that of the interactions.
std::vector<double> component_shares(const std::vector<double>& parts, std::size_t factors) {
  std::vector<double> shares(factors + 1, 0.0);
  double total = 0.0;
  for (Subset set = 1; set < parts.size(); ++set) {
    total += parts[set];
    shares[std::popcount(set) == 1 ? static_cast<std::size_t>(std::countr_zero(set)) : factors] +=
        parts[set];
  }
  if (total > 0.0) {
    for (double& share : shares) share /= total;
  }
  return shares;
}

/// A chi-squared number: twice a gamma number of half the freedom.
/// @cite marsaglia2000
double draw_chi_squared(double degrees_of_freedom, Random& random) {
  const double shape = 0.5 * degrees_of_freedom;
  // Below one: a gamma number of one more, times a power of a uniform one.
  const double raised = shape < 1.0 ? shape + 1.0 : shape;
  const double d = raised - 1.0 / 3.0, c = 1.0 / std::sqrt(9.0 * d);
  while (true) {
    const double x = random.normal();
    const double v = std::pow(1.0 + c * x, 3.0);
    const double u = 1.0 - random.uniform();  // above zero
    if (v <= 0.0 || std::log(u) >= 0.5 * x * x + d - d * v + d * std::log(v)) continue;
    const double power = shape < 1.0 ? std::pow(1.0 - random.uniform(), 1.0 / shape) : 1.0;
    return 2.0 * d * v * power;
  }
}

void check_design(std::span<const double> values, std::span<const std::size_t> levels) {
  std::size_t count = 1;
  for (const std::size_t number : levels) {
    if (number < 2) throw InputError("a factor of one level explains no variance");
    count *= number;
  }
  if (levels.empty() || levels.size() > kMaxCrossedFactors || count != values.size()) {
    throw InputError(std::to_string(values.size()) + " values are not a full design of " +
                     std::to_string(levels.size()) + " factors with " + std::to_string(count) +
                     " combinations");
  }
}

}  // namespace

VarianceDecomposition decompose_variance(std::span<const double> values,
                                         std::span<const std::size_t> levels, std::uint64_t seed) {
  check_design(values, levels);
  const std::size_t factors = levels.size();
  double mean = 0.0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  std::vector<double> centred;
  for (const double value : values) centred.push_back(value - mean);
  const Analysis analysis = analysis_of(centred, levels);

  std::vector<double> mean_squares(analysis.squares.size(), 0.0);
  for (Subset set = 1; set < mean_squares.size(); ++set) {
    mean_squares[set] = analysis.squares[set] / analysis.degrees_of_freedom[set];
  }
  const std::vector<double> components = balanced_components(analysis, mean_squares);
  const std::vector<double> design = component_shares(analysis.squares, factors);
  const std::vector<double> estimate = component_shares(components, factors);

  Random random(seed);
  std::vector<std::vector<double>> drawn(factors + 1);
  for (std::size_t i = 0; i < kDraws; ++i) {
    std::vector<double> tried(mean_squares.size(), 0.0);
    for (Subset set = 1; set < tried.size(); ++set) {
      tried[set] =
          analysis.squares[set] / draw_chi_squared(analysis.degrees_of_freedom[set], random);
    }
    const std::vector<double> shares =
        component_shares(balanced_components(analysis, tried), factors);
    for (std::size_t f = 0; f <= factors; ++f) drawn[f].push_back(shares[f]);
  }
  VarianceDecomposition result;
  for (const double component : components) result.variance += component;
  for (std::size_t f = 0; f <= factors; ++f) {
    std::sort(drawn[f].begin(), drawn[f].end());
    VarianceFraction share{design[f],
                           estimate[f],
                           {std::min(estimate[f], quantile(drawn[f], kLow)),
                            std::max(estimate[f], quantile(drawn[f], kHigh))}};
    if (f < factors) {
      result.factors.push_back(share);
    } else {
      result.interactions = share;
    }
  }
  return result;
}

}  // namespace clast
