#pragma once
/// Statistics of a population, and comparison of two populations.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "classify/population.hpp"
#include "classify/shape_measures.hpp"
#include "classify/size_distribution.hpp"
#include "core/statistics/sample_tests.hpp"

namespace clast {

struct PopulationOptions {
  SizeMeasure size = SizeMeasure::kIntermediate;
  std::uint64_t seed = 1;                 ///< seed of the random samples for p-values
  std::vector<std::string> schemes = {};  ///< names of the schemes; empty for all
  SchemeOptions limits = {};              ///< class limits that the schemes leave open

  /// Returns `schemes`, or all known schemes if it is empty.
  const std::vector<std::string>& selected_schemes() const;
  void check() const;  ///< throws InputError naming the field and its value
};

struct SchemeFractions {
  std::string scheme;
  std::vector<ClassFraction> fractions;
};

/// Spearman correlation between the size of blocks and a shape measure.
struct SizeShapeCorrelation {
  const ShapeMeasure* measure = nullptr;
  std::size_t blocks = 0;          ///< number of blocks with a value of the measure
  std::optional<TestResult> test;  ///< permutation test of the correlation
};

std::string describe_size_shape(const SizeShapeCorrelation& relation, SizeMeasure size);

struct PopulationSummary {
  std::string name;
  std::size_t blocks = 0;
  std::size_t blocks_with_mass = 0;
  std::vector<SchemeFractions> schemes;
  SizeDistribution size;
  std::vector<SizeShapeCorrelation> size_shape_correlations;
  double c40 = 0.0;  ///< fraction of blocks with S/L <= 0.4
};

/// Computes the statistics of a population.
/// @throws InputError  if the population is empty or a scheme is unknown
PopulationSummary summarise_population(const Population& population,
                                       const PopulationOptions& options = {});

/// Difference of two populations in one shape measure.
struct ShapeMeasureDifference {
  const ShapeMeasure* measure = nullptr;
  double median_a = 0.0;
  double median_b = 0.0;
  std::optional<TestResult> test;  ///< Kolmogorov-Smirnov test; empty if a population has no values
  std::string description;         ///< sentence that states the conclusion
};

/// Difference of two populations in the classes of one scheme.
struct ClassFractionDifference {
  std::string scheme;
  std::optional<ChiSquaredResult>
      test;  ///< empty if all blocks of both populations have the same class
  std::string description;
};

struct PopulationComparison {
  std::string name_a;
  std::string name_b;
  std::vector<ShapeMeasureDifference> measures;
  std::vector<ClassFractionDifference> schemes;
};

/// Significance level. Smaller p-values are reported as differences. This happens by chance in one
/// of twenty comparisons of equal populations.
inline constexpr double kSignificanceLevel = 0.05;

/// Compares two populations in all shape measures and schemes.
/// @throws InputError  if one of them is empty, or a scheme is unknown
PopulationComparison compare_populations(const Population& a, const Population& b,
                                         const PopulationOptions& options = {});

/// Formats a p-value as "0.034" or "less than 0.0001".
std::string format_p_value(double p_value);

}  // namespace clast
