#pragma once
/// The statistics of a population, and the comparison of two.
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
  std::uint64_t seed = 1;                 ///< of the random samples behind p-values
  std::vector<std::string> schemes = {};  ///< empty: all
  SchemeOptions limits = {};              ///< of the schemes that leave them open

  /// `schemes`, or all.
  const std::vector<std::string>& selected_schemes() const;
  void check() const;  ///< throws InputError naming the field and its value
};

struct SchemeFractions {
  std::string scheme;
  std::vector<ClassFraction> shares;
};

/// Spearman's correlation of size with one measure of shape.
struct SizeShapeCorrelation {
  const ShapeMeasure* measure = nullptr;
  std::size_t blocks = 0;          ///< with a value
  std::optional<TestResult> test;  ///< none for too few blocks, or sizes or shapes that don't vary
};

/// A sentence to quote.
std::string describe_size_shape(const SizeShapeCorrelation& relation, SizeMeasure size);

struct PopulationSummary {
  std::string name;
  std::size_t blocks = 0;
  std::size_t with_mass = 0;
  std::vector<SchemeFractions> schemes;
  SizeDistribution size;
  std::vector<SizeShapeCorrelation> size_shape_correlations;
  double c40 = 0.0;  ///< share with S/L <= 0.4
};

/// @throws InputError  no blocks, or an unknown scheme
PopulationSummary summarise_population(const Population& population,
                                       const PopulationOptions& options = {});

/// Two populations on one measure of shape.
struct MeasureDifference {
  const ShapeMeasure* measure = nullptr;
  double median_a = 0.0;
  double median_b = 0.0;
  std::optional<TestResult> test;  ///< Kolmogorov-Smirnov; none when a population has no values
  std::string description;         ///< a sentence to quote
};

/// Two populations on the classes of one scheme.
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

/// Differences below this p-value are called differences: one comparison in twenty of equal
/// populations reaches it by chance.
inline constexpr double kSignificanceLevel = 0.05;

/// @throws InputError  either has no blocks, or an unknown scheme
PopulationComparison compare_populations(const Population& a, const Population& b,
                                         const PopulationOptions& options = {});

/// "0.034", "less than 0.0001".
std::string format_p_value(double p_value);

}  // namespace clast
