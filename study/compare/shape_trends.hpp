#pragma once
/// Do outcomes rise or fall with elongation, flatness, convexity, rounding and mass of the blocks,
/// is what they do too little to matter, and how many runs would it take to know?
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/crossed_difference.hpp"
#include "core/statistics/sample_tests.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// One outcome against one property of the blocks.
struct ShapeTrend {
  std::string outcome;   ///< "runout", "lateral angle", "largest energy", or "passing BARRIER"
  std::string unit;      ///< "m", "rad", "J"; empty: a share of runs
  std::string property;  ///< "I/L", "S/L", "convexity", "rounding", "mass"
  std::size_t blocks = 0;
  std::size_t runs = 0;
  TestResult trend;          ///< rank correlation, as `clustered_trend_test`
  double corrected_p = 1.0;  ///< of the trend, over all properties of the outcome (Holm)
  double limit = 0.0;        ///< property of the blocks between the lower and the upper half
  /// Upper half of the blocks less the lower one.
  CrossedDifference halves;
  double smallest = 0.0;  ///< difference that a campaign like this finds in 80 % of cases
  /// Of the runout, where a margin was given: as `equivalence_p_value`, and the runs that find a
  /// difference of the margin.
  std::optional<double> equivalence;
  std::optional<double> runs_needed;
};

/// Of one results file.
struct ShapeTrends {
  std::uint32_t file = 0;
  std::vector<ShapeTrend> trends;  ///< by outcome, then property; empty where there is nothing
};

/// For every file with four blocks or more, whether or not every combination was run; none where
/// blocks stay. Rounding is the Minkowski radius over S. Properties that differ by less than a
/// hundredth over all blocks are left out. Where each block of the library comes in several masses,
/// masses are compared within blocks of the library, and forms over all masses.
std::vector<ShapeTrends> compute_shape_trends(const Comparison& comparison);

}  // namespace clast
