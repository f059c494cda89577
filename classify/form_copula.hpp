#pragma once
/// Joint distribution of size and shape in a population of blocks, for sampling.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classify/form.hpp"
#include "core/random.hpp"

namespace clast {

/// Size and shape of a block.
struct BlockForm {
  Axes axes;                        ///< m
  std::optional<double> convexity;  ///< empty if unknown
};

/// Rank correlation of two measures, in the population and in the sampled blocks.
struct RankCorrelation {
  std::string first, second;
  double population = 0.0, sampled = 0.0;  ///< Spearman's coefficient
};

/// Measures of the agreement of sampled blocks with their population.
struct CopulaFit {
  std::vector<RankCorrelation> correlations;
  /// Largest difference between the distribution functions of population and sampled blocks
  /// (Smirnov's D), over all measures.
  double max_cdf_difference = 0.0;
  /// Fraction by which the rank correlations were reduced to make their matrix positive definite.
  double removed_correlation = 0.0;
};

/// Joint distribution of ln L, I/L and S/I, and of the convexity if all blocks have one. The
/// marginals are the empirical distributions, linear between order statistics. They are joined by a
/// Gaussian copula. Its normal correlations are 2 sin(pi r/6) for the rank correlations r of the
/// population [kruskal1958]. Sampled ratios are in (0, 1], so L >= I >= S.
/// @cite kruskal1958 @cite nelsen2006
class FormCopula {
 public:
  /// Fits the distribution to a population.
  /// @throws InputError  if there are fewer than ten blocks, or if axes are not positive
  explicit FormCopula(std::span<const BlockForm> population);

  BlockForm sample(Random& random) const;
  CopulaFit assess_fit(std::span<const BlockForm> drawn) const;

 private:
  using Values = std::vector<std::vector<double>>;  ///< values [measure][block]
  static Values measure_values(std::span<const BlockForm> blocks, bool convexity);

  bool has_convexity_ = false;
  Values values_;  ///< values of the population, in its order
  Values sorted_;  ///< values of each measure, ascending
  std::vector<std::vector<double>>
      mixing_;  ///< lower triangular matrix that maps independent to correlated normal variates
  double removed_correlation_ = 0.0;
};

}  // namespace clast
