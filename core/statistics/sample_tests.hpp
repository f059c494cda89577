#pragma once
/// Tests of samples: do two differ, do two quantities go together.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace clast {

/// A statistic and the probability of one as large or larger when there is nothing to find.
struct TestResult {
  double statistic = 0.0;
  double p_value = 1.0;
  bool exact = true;  ///< p from all arrangements of these values; else from a limit or from draws
};

/// Kolmogorov's and Smirnov's test of two samples: the largest distance D of their cumulative
/// shares. p is the share of the (m + n)!/(m! n!) ways to deal the pooled values to two samples
/// that give at least this D, ties kept; beyond m n = 10^7 it is Kolmogorov's limit, which is too
/// large when there are ties.
/// @param a, b  finite
/// @return none when either is empty
/// @cite smirnov1939
std::optional<TestResult> two_sample_ks_test(std::span<const double> a, std::span<const double> b);

/// Spearman's rank correlation, in [-1, 1]; ties share their mean rank. p is two-sided: from all n!
/// orders up to n = 9, from Student's t with n - 2 degrees of freedom beyond.
/// @param x, y  finite, of one length
/// @return none below three pairs, or when all x or all y are equal
/// @cite spearman1904
std::optional<TestResult> spearman_test(std::span<const double> x, std::span<const double> y);

/// Pearson's test of whether two samples have the same shares of classes.
struct ChiSquaredResult {
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;         ///< classes that occur, less one
  double smallest_expected = 0.0;  ///< count
  double p_value = 1.0;
  std::size_t draws =
      0;  ///< random tables behind p; 0 when it is from the chi-squared distribution
};

/// Classes that neither sample has are left out. Where an expected count is below 5 the
/// distribution is no guide: p is then from `draws` random tables with the same row and column
/// sums, as (1 + as extreme)/(1 + draws).
/// @param a, b   counts by class, of one length
/// @param draws  positive
/// @return none when either sample is empty or fewer than two classes occur
/// @cite pearson1900, cochran1954
std::optional<ChiSquaredResult> chi_squared_test(std::span<const std::size_t> a,
                                      std::span<const std::size_t> b, std::uint64_t seed,
                                      std::size_t draws = 9999);

/// Ranks from 1; equal values share the mean of theirs.
std::vector<double> ranks(std::span<const double> values);

}  // namespace clast
