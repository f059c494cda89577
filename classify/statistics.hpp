#pragma once
/// Samples of numbers: quantiles, correlation, and tests of whether two come from one population.
#include <cstddef>
#include <span>
#include <vector>

namespace clast {

/// Linear interpolation between order statistics (type 7). @cite hyndman1996
/// @param share  in [0, 1]; sample not empty
double quantile(std::vector<double> sample, double share);

/// The value below which lies the share of the weight, interpolated between the middles of the
/// steps of the weighted distribution.
double weighted_quantile(std::span<const double> sample, std::span<const double> weights,
                         double share);

/// Rank correlation in [-1, 1], ties at their mean rank; 0 when a sample does not vary.
/// @cite spearman1904
double rank_correlation(std::span<const double> x, std::span<const double> y);

/// A statistic and the probability of one as large or larger where there is no difference.
struct TestResult {
  double statistic = 0.0;
  double p_value = 1.0;
  std::size_t degrees = 0;    ///< of freedom; chi-squared only
  bool small_counts = false;  ///< chi-squared only: an expected count is below 5, so that the
                              ///< probability is rough
};

/// Two-sample Kolmogorov-Smirnov: the largest distance between the two distributions. The
/// probability is asymptotic, with Stephens' correction for small samples; too large with ties.
/// @param a  neither sample empty
/// @cite stephens1970
TestResult kolmogorov_smirnov(std::vector<double> a, std::vector<double> b);

/// Pearson's test of two rows of counts of the same classes. Classes empty in both are left out.
/// @cite pearson1900
TestResult chi_squared(std::span<const std::size_t> a, std::span<const std::size_t> b);

}  // namespace clast
