#pragma once
/// Two-sample and correlation tests.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace clast {

/// Test statistic with its p-value.
struct TestResult {
  double statistic = 0.0;
  double p_value = 1.0;
  bool exact = true;  ///< true if p comes from all permutations, false if from a limit distribution
                      ///< or random permutations
};

/// Two-sample Kolmogorov-Smirnov test for samples of m and n values. The p-value is exact also with
/// ties: the fraction of all (m + n)!/(m! n!) assignments with at least the observed distance D.
/// Above m n = 10^7 it is from Kolmogorov's limit distribution, which is conservative with ties.
/// @param a, b  finite
/// @return empty if a sample is empty
/// @cite smirnov1939
std::optional<TestResult> two_sample_ks_test(std::span<const double> a, std::span<const double> b);

/// Spearman's rank correlation in [-1, 1], with mean ranks for ties and a two-sided p-value: from
/// all n! permutations up to n = 9, otherwise from Student's t with n - 2 degrees of freedom.
/// @param x, y  finite, of equal length
/// @return correlation and p; empty for fewer than three pairs, or if all x or all y are equal
/// @cite spearman1904
std::optional<TestResult> spearman_test(std::span<const double> x, std::span<const double> y);

/// Pearson's chi-squared test of equal class fractions.
struct ChiSquaredResult {
  double chi_squared = 0.0;
  std::size_t degrees_of_freedom = 0;  ///< number of occurring classes minus one
  double smallest_expected = 0.0;      ///< smallest expected count
  double p_value = 1.0;
  std::size_t draws =
      0;  ///< number of random tables for p; 0 if p is from the chi-squared distribution
};

/// Tests the hypothesis that two samples have equal class fractions. Empty classes are ignored. If
/// an expected count is below 5, the p-value is from `draws` random tables with the same margins:
/// (1 + number of at least as extreme tables)/(1 + draws).
/// @param a, b  number of items in each class; both of equal length
/// @param draws  number of random tables, positive
/// @return empty if a sample is empty, or if fewer than two classes occur
/// @cite pearson1900, cochran1954
std::optional<ChiSquaredResult> chi_squared_test(std::span<const std::size_t> a,
                                                 std::span<const std::size_t> b, std::uint64_t seed,
                                                 std::size_t draws = 9999);

/// Returns ranks from 1, with mean ranks for ties.
std::vector<double> fractional_ranks(std::span<const double> values);

}  // namespace clast
