#pragma once
/// Block size distributions: percentiles and fitted laws.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classify/population.hpp"

namespace clast {

enum class SizeMeasure {
  kIntermediate,  ///< I: the axis that determines the passing sieve
  kMean,          ///< (L I S)^(1/3): side of the cube with the volume of the box
};
/// Returns the size of a block, m.
double block_size(const Axes& axes, SizeMeasure measure);
/// Returns "I" or "(L I S)^(1/3)".
std::string name_of(SizeMeasure measure);

enum class SizeLawKind {
  kLogNormal,     ///< location: median; spread: standard deviation of ln d
  kRosinRammler,  ///< fraction above d is exp(-(d/location)^spread): Weibull distribution
};
/// Returns "log-normal" or "Rosin-Rammler".
std::string name_of(SizeLawKind kind);

/// Size law fitted by maximum likelihood, with standard errors from the Fisher information.
struct FittedSizeLaw {
  SizeLawKind kind = SizeLawKind::kLogNormal;
  double location = 0.0;  ///< m; exceeded by 50 % (log-normal) or 36.8 % (Rosin-Rammler)
  double location_error = 0.0;
  double spread = 0.0;
  double spread_error = 0.0;
  double distance = 0.0;  ///< Kolmogorov-Smirnov distance of sample and law
  std::optional<double>
      p_value;  ///< of samples from the law itself, those that lie as far from their own fit

  /// Returns the fraction of blocks up to a size.
  double fraction_below(double size) const;
};

/// Fits a size law.
/// @param sizes  m, positive
/// @param weights  one per size, not all zero; empty: equal weights. Errors are those of a sample
///                 of size (sum of w)^2 / sum of w^2
/// @return empty if fewer than two different sizes have weight
/// @cite rosin1933
std::optional<FittedSizeLaw> fit_size_law(SizeLawKind kind, std::span<const double> sizes,
                                          std::span<const double> weights = {});

/// Finds the reading resolution of sizes, such as 5 cm by tape: the largest of 1, 2, 5, 10, ...
/// times their common divisor (within 1e-6 of the largest value) of which at least 90 % of the
/// values are multiples; 0 if there is none above 1e-4 of the largest.
double find_reading_resolution(std::span<const double> values);

/// Computes the goodness of fit: distance and p-value by parametric bootstrap
/// (`bootstrap_ks_distances`), because Kolmogorov's tables are not valid for fitted parameters.
/// Above 1,000 sizes, bootstrap samples have 1,000, and D is scaled by the root of the number.
/// @param step  reading resolution, m; 0 for continuous sizes. Curves are then compared halfway
///              between readings
/// @cite stephens1974
void test_size_law(FittedSizeLaw& law, std::span<const double> sizes, double step,
                   std::uint64_t seed, std::size_t samples = 999);

/// Returns the distances of `samples` bootstrap samples of `count` sizes, drawn from the law and
/// rounded to `step`, each from the law fitted to itself. Samples with equal readings are skipped.
std::vector<double> bootstrap_ks_distances(const FittedSizeLaw& law, std::size_t count, double step,
                                           std::uint64_t seed, std::size_t samples);

/// Percentiles and fitted laws by number or by mass.
struct SizeCurve {
  std::size_t blocks = 0;
  double d10 = 0.0;  ///< m
  double d50 = 0.0;
  double d90 = 0.0;
  std::vector<FittedSizeLaw> laws;  ///< log-normal, Rosin-Rammler; empty if all sizes are equal
};

struct SizeDistribution {
  SizeMeasure measure = SizeMeasure::kIntermediate;
  double step = 0.0;    ///< reading resolution, m; 0 if continuous
  SizeCurve by_number;  ///< percentiles linear between order statistics
  std::optional<SizeCurve>
      by_mass;  ///< of the blocks with a mass: size up to which a share of the mass lies
  double total_mass = 0.0;  ///< kg
};

/// Computes the size distribution. Unscaled blocks are skipped; if all are, `by_number.blocks` is 0
/// and the rest empty.
/// @param population  not empty
SizeDistribution size_distribution(const Population& population, SizeMeasure measure,
                                   std::uint64_t seed);

/// Returns the smallest size up to which at least `fraction` of the weight lies.
/// @param sizes, weights  of equal length, not empty
double weighted_percentile(std::span<const double> sizes, std::span<const double> weights,
                           double fraction);

}  // namespace clast
