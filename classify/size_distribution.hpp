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
  kIntermediate,  ///< I, the axis that determines the passing sieve
  kMean,          ///< (L I S)^(1/3), side of the cube with the volume of the box
};
/// Returns the size of a block, m.
double block_size(const Axes& axes, SizeMeasure measure);
/// Returns the name of a measure: "I" or "(L I S)^(1/3)".
std::string name_of(SizeMeasure measure);

enum class SizeLawKind {
  kLogNormal,     ///< location is the median, spread the standard deviation of ln d
  kRosinRammler,  ///< Weibull distribution; the fraction above d is exp(-(d/location)^spread)
};
/// Returns the name of a law: "log-normal" or "Rosin-Rammler".
std::string name_of(SizeLawKind kind);

/// Size law fitted by maximum likelihood, with standard errors from the Fisher information.
struct FittedSizeLaw {
  SizeLawKind kind = SizeLawKind::kLogNormal;
  double location = 0.0;  ///< size exceeded by 50 % (log-normal) or 36.8 % (Rosin-Rammler), m
  double location_error = 0.0;
  double spread = 0.0;
  double spread_error = 0.0;
  double distance = 0.0;          ///< Kolmogorov-Smirnov distance of sample and law
  std::optional<double> p_value;  ///< fraction of samples drawn from the law that are at least as
                                  ///< far from their own fit

  /// Returns the fraction of blocks that are not larger than `size`.
  double fraction_below(double size) const;
};

/// Fits a size law to block sizes by maximum likelihood.
/// @param sizes  m, positive
/// @param weights  one weight w per size, not all zero; if empty, weights are equal. Errors are
///                 those of a sample of (sum of w)^2 / sum of w^2 blocks
/// @return empty if fewer than two different sizes have a positive weight
/// @cite rosin1933
std::optional<FittedSizeLaw> fit_size_law(SizeLawKind kind, std::span<const double> sizes,
                                          std::span<const double> weights = {});

/// Finds the reading resolution of sizes, such as 5 cm for a tape. At least 90 % of the values are
/// multiples of it. Candidates are 1, 2, 5, 10, ... times the common divisor of the values. 0 if
/// there is none above 1e-4 of the largest value.
double find_reading_resolution(std::span<const double> values);

/// Computes the goodness of fit of a size law and stores it in `law`: Kolmogorov-Smirnov distance D
/// and p-value. The p-value is that of a parametric bootstrap (`bootstrap_ks_distances`), because
/// Kolmogorov's tables are not valid for fitted parameters. If there are more than 1,000 sizes,
/// bootstrap samples have 1,000, and D is scaled by the square root of the number.
/// @param step  reading resolution, m; 0 for continuous sizes. If positive, distributions are
///              compared halfway between readings
/// @cite stephens1974
void compute_goodness_of_fit(FittedSizeLaw& law, std::span<const double> sizes, double step,
                             std::uint64_t seed, std::size_t samples = 999);

/// Computes the Kolmogorov-Smirnov distances of `samples` bootstrap samples from the laws fitted to
/// them. A sample has `count` sizes, which are drawn from `law` and rounded to `step`. Samples with
/// equal readings are skipped.
std::vector<double> bootstrap_ks_distances(const FittedSizeLaw& law, std::size_t count, double step,
                                           std::uint64_t seed, std::size_t samples);

/// Percentiles and fitted laws of block sizes, weighted by number or by mass.
struct SizeCurve {
  std::size_t blocks = 0;
  double d10 = 0.0;  ///< m
  double d50 = 0.0;
  double d90 = 0.0;
  std::vector<FittedSizeLaw>
      laws;  ///< log-normal and Rosin-Rammler law; empty if all sizes are equal
};

struct SizeDistribution {
  SizeMeasure measure = SizeMeasure::kIntermediate;
  double step = 0.0;    ///< reading resolution, m; 0 for continuous sizes
  SizeCurve by_number;  ///< curve by number, with percentiles linear between order statistics
  std::optional<SizeCurve> by_mass;  ///< curve by mass of the blocks with a known mass
  double total_mass = 0.0;           ///< kg
};

/// Computes the size distribution. Unscaled blocks are skipped. If all blocks are skipped,
/// `by_number.blocks` is 0 and the rest is empty.
/// @param population  not empty
SizeDistribution size_distribution(const Population& population, SizeMeasure measure,
                                   std::uint64_t seed);

/// Returns the smallest size up to which blocks have at least `fraction` of the total weight.
/// @param sizes, weights  of equal length, not empty
double weighted_percentile(std::span<const double> sizes, std::span<const double> weights,
                           double fraction);
/// Returns `weighted_percentile` for each fraction; sizes are sorted once.
std::vector<double> weighted_percentiles(std::span<const double> sizes,
                                         std::span<const double> weights,
                                         std::span<const double> fractions);

}  // namespace clast
