#pragma once
/// Joint distribution of size and form in a population of blocks, for sampling.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classify/form.hpp"
#include "core/random.hpp"

namespace clast {

struct BlockForm {
  Axes axes;                        ///< m
  std::optional<double> convexity;  ///< empty if unknown
};

/// Rank correlation of two measures, in the population and in the blocks drawn from it.
struct RankCorrelation {
  std::string first, second;
  double population = 0.0, drawn = 0.0;  ///< Spearman's coefficient
};

/// Goodness of fit between drawn blocks and their population.
struct CopulaFit {
  std::vector<RankCorrelation> correlations;
  /// Largest difference between the distribution functions of population and drawn blocks over all
  /// measures (Smirnov's D).
  double max_cdf_difference = 0.0;
  /// Reduction of the rank correlations that made their matrix positive definite, as a fraction;
  /// usually 0.
  double removed_correlation = 0.0;
};

/// Joint distribution of ln L, I/L and S/I, and of the convexity if all blocks have one. The
/// marginals are the empirical distributions, linear between order statistics. A Gaussian copula
/// joins them, with normal correlations 2 sin(pi r/6) for the rank correlations r of the population
/// [kruskal1958]. Ratios stay in (0, 1], so that L >= I >= S holds for all drawn blocks.
/// @cite kruskal1958 @cite nelsen2006
class FormCopula {
 public:
  /// Fits the distribution to a population.
  /// @throws InputError  for fewer than ten blocks, or axes that are not positive
  explicit FormCopula(std::span<const BlockForm> population);

  BlockForm sample(Random& random) const;
  CopulaFit assess_fit(std::span<const BlockForm> drawn) const;

 private:
  using Values = std::vector<std::vector<double>>;  ///< values [measure][block]
  static Values measure_values(std::span<const BlockForm> blocks, bool convexity);

  bool has_convexity_ = false;
  Values values_;  ///< of the population, in its order
  Values sorted_;  ///< ascending
  std::vector<std::vector<double>>
      mixing_;  ///< lower triangular matrix from independent to correlated normals
  double removed_correlation_ = 0.0;
};

}  // namespace clast
