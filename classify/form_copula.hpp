#pragma once
/// Sizes and forms of a population of blocks as a distribution to draw from.
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classify/form.hpp"
#include "core/random.hpp"

namespace clast {

/// A block as the distribution knows it.
struct BlockForm {
  Axes axes;                        ///< m
  std::optional<double> convexity;  ///< where the population has it
};

/// How two measures go together, in the population and in blocks drawn from it.
struct RankCorrelation {
  std::string first, second;
  double population = 0.0, drawn = 0.0;  ///< Spearman's
};

/// How well drawn blocks stand for the population.
struct CopulaFit {
  std::vector<RankCorrelation> correlations;
  /// Largest difference between the distribution functions of population and drawn blocks, over
  /// all measures: Smirnov's D.
  double max_cdf_difference = 0.0;
  /// Share of the rank correlations that had to be left out for the matrix to be one; mostly 0.
  double removed_correlation = 0.0;
};

/// The joint distribution of ln L, I/L and S/I, and of convexity where every block has it: each as
/// in the population (its empirical distribution, linear between order statistics), joined by a
/// Gaussian copula with the population's rank correlations r, 2 sin(pi r/6) of the normals
/// [kruskal1958]. I/L and S/I stay in (0, 1], so that L >= I >= S of every block drawn.
/// @cite kruskal1958 @cite nelsen2006
class FormCopula {
 public:
  /// @throws InputError  fewer than ten blocks; axes that aren't positive
  explicit FormCopula(std::span<const BlockForm> population);

  BlockForm sample(Random& random) const;
  /// Of blocks that `sample` gave.
  CopulaFit assess_fit(std::span<const BlockForm> drawn) const;

 private:
  using Values = std::vector<std::vector<double>>;  ///< by measure, then by block
  static Values measure_values(std::span<const BlockForm> blocks, bool convexity);

  bool has_convexity_ = false;
  Values values_;                            ///< of the population, as it came
  Values sorted_;                            ///< ascending
  std::vector<std::vector<double>> mixing_;  ///< lower triangle: correlated from free normals
  double removed_correlation_ = 0.0;
};

}  // namespace clast
