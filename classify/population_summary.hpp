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
  std::uint64_t seed = 1;                 ///< random samples for p-values
  std::vector<std::string> schemes = {};  ///< empty: all
  SchemeOptions limits = {};              ///< class limits that the schemes leave open

  /// Returns `schemes`, or all known schemes if it is empty.
  const std::vector<std::string>& selected_schemes() const;
  void check() const;  ///< throws InputError naming the field and its value
};

struct SchemeFractions {
  std::string scheme;
  std::vector<ClassFraction> shares;
};

/// Spearman correlation between size and a shape measure.
struct SizeShapeCorrelation {
  const ShapeMeasure* measure = nullptr;
  std::size_t blocks = 0;          ///< with a value of the measure
  std::optional<TestResult> test;  ///< Kolmogorov-Smirnov; empty if a population has no values
};

std::string describe_size_shape(const SizeShapeCorrelation& relation, SizeMeasure size);

struct PopulationSummary {
  std::string name;
  std::size_t blocks = 0;
  std::size_t with_mass = 0;
  std::vector<SchemeFractions> schemes;
  SizeDistribution size;
  std::vector<SizeShapeCorrelation> size_shape_correlations;
  double c40 = 0.0;  ///< fraction with S/L <= 0.4
};

/// Computes the statistics of a population.
/// @throws InputError  for an empty population or an unknown scheme
PopulationSummary summarise_population(const Population& population,
                                       const PopulationOptions& options = {});

/// Difference of two populations in one shape measure.
struct MeasureDifference {
  const ShapeMeasure* measure = nullptr;
  double median_a = 0.0;
  double median_b = 0.0;
  std::optional<TestResult> test;  ///< Kolmogorov-Smirnov; none when a population has no values
  std::string description;         ///< conclusion as a sentence
};

/// Difference of two populations in the classes of one scheme.
struct ClassDifference {
  std::string scheme;
  std::optional<ChiSquaredResult> test;  ///< none when all blocks of both are of one class
  std::string description;
};

struct PopulationComparison {
  std::string name_a;
  std::string name_b;
  std::vector<MeasureDifference> measures;
  std::vector<ClassDifference> schemes;
};

/// Significance level: p-values below it are reported as differences, which happens by chance in
/// one of twenty comparisons of equal populations.
inline constexpr double kSignificanceLevel = 0.05;

/// Compares two populations in all shape measures and schemes.
/// @throws InputError  if one of them is empty, or a scheme is unknown
PopulationComparison compare_populations(const Population& a, const Population& b,
                                         const PopulationOptions& options = {});

/// Formats a p-value as "0.034" or "less than 0.0001".
std::string format_p_value(double p_value);

}  // namespace clast
