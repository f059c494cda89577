#pragma once
/// Trends of outcomes with elongation, flatness, convexity, rounding and mass of the blocks.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/crossed_difference.hpp"
#include "core/statistics/sample_tests.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// Trend of one outcome with one property of the blocks.
struct ShapeTrend {
  std::string outcome;   ///< name of the outcome, such as "runout"
  std::string unit;      ///< unit of the outcome; empty for a fraction of runs
  std::string property;  ///< name of the property, such as "I/L" or "mass"
  std::size_t blocks = 0;
  std::size_t runs = 0;
  TestResult trend;          ///< rank correlation with its test
  double corrected_p = 1.0;  ///< p-value of the trend, Holm-corrected for the number of properties
  /// Median of the property, which divides the blocks into a lower and an upper half.
  double limit = 0.0;
  /// Difference in mean outcome between the two halves of the blocks, upper minus lower.
  CrossedDifference halves;
  /// Smallest difference between the two halves that is detected with 80 % power.
  double detectable_difference = 0.0;
  /// P-value of the test that the mean runouts of the two halves differ by less than the margin.
  /// Empty for outcomes other than runout, or without a margin.
  std::optional<double> equivalence;
  std::optional<double> runs_needed;
};

struct ShapeTrends {
  std::uint32_t file = 0;
  std::vector<ShapeTrend> trends;  ///< trends, by outcome, then property; may be empty
};

/// Computes the trends of outcomes with block properties, for each file with at least four blocks
/// and without persistent blocks. Properties that vary by less than 0.01 are omitted.
std::vector<ShapeTrends> compute_shape_trends(const Comparison& comparison);

}  // namespace clast
