#pragma once
/// Trends of outcomes with elongation, flatness, convexity, rounding and mass of the blocks.
/// Equivalence tests and required sample sizes are included.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/crossed_difference.hpp"
#include "core/statistics/sample_tests.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// Trend of one outcome with one block property.
struct ShapeTrend {
  std::string outcome;   ///< "runout", "lateral angle", "largest energy", or "passing BARRIER"
  std::string unit;      ///< "m", "rad", "J"; empty for a proportion of runs
  std::string property;  ///< "I/L", "S/L", "convexity", "rounding", "mass"
  std::size_t blocks = 0;
  std::size_t runs = 0;
  TestResult trend;          ///< rank correlation (`clustered_trend_test`)
  double corrected_p = 1.0;  ///< p-value of the trend, Holm-corrected for the number of properties
  double limit =
      0.0;  ///< median of the property, which divides the blocks into a lower and an upper half
  /// Mean outcome of the upper half of the blocks minus that of the lower half.
  CrossedDifference halves;
  double detectable_difference =
      0.0;  ///< minimum difference that this design detects with 80 % power
  /// The p-value of the equivalence test (`equivalence_p_value`), and the number of runs needed to
  /// detect a difference as large as the margin. Only for the runout, and if there is a margin.
  std::optional<double> equivalence;
  std::optional<double> runs_needed;
};

struct ShapeTrends {
  std::uint32_t file = 0;
  std::vector<ShapeTrend> trends;  ///< by outcome, then property; may be empty
};

/// Computes the trends of each file with at least four blocks and without persistent blocks. The
/// design may be incomplete. Rounding is the Minkowski radius divided by S. Properties that vary by
/// less than 0.01 over all blocks are omitted. If each library block occurs with several masses,
/// masses are compared within blocks, and shapes over all masses.
std::vector<ShapeTrends> compute_shape_trends(const Comparison& comparison);

}  // namespace clast
