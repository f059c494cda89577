#pragma once
/// Sizes of the blocks of a population: percentiles, and the two laws that are fitted to them.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "classify/population.hpp"

namespace clast {

enum class SizeMeasure {
  kIntermediate,  ///< I: the axis that decides which sieve lets a block through
  kMean,          ///< (L I S)^(1/3): the side of a cube as large as the block's box
};
/// m
double block_size(const Axes& axes, SizeMeasure measure);
/// "I" or "(L I S)^(1/3)".
std::string name_of(SizeMeasure measure);

enum class SizeLawKind {
  kLogNormal,     ///< ln d is normal: location = median, spread = standard deviation of ln d
  kRosinRammler,  ///< share above d is exp(-(d/location)^spread); Weibull's distribution
};
/// "log-normal" or "Rosin-Rammler".
std::string name_of(SizeLawKind kind);

/// A law fitted by maximum likelihood, with standard errors from the Fisher information.
struct FittedSizeLaw {
  SizeLawKind kind = SizeLawKind::kLogNormal;
  double location = 0.0;  ///< m; exceeded by 50 % (log-normal) or 36.8 % (Rosin-Rammler)
  double location_error = 0.0;
  double spread = 0.0;
  double spread_error = 0.0;
  double distance = 0.0;  ///< largest between the curves of sample and law (Kolmogorov-Smirnov)
  std::optional<double>
      p_value;  ///< of samples from the law itself, those that lie as far from their own fit

  /// Share of blocks at or below a size.
  double fraction_below(double size) const;
};

/// @param sizes    m, positive
/// @param weights  of each size, not all zero; or empty when all count alike. The errors are then
///                 of a sample of (sum of w)^2 / sum of w^2.
/// @return none when fewer than two different sizes carry weight
/// @cite rosin1933
std::optional<FittedSizeLaw> fit_size_law(SizeLawKind kind, std::span<const double> sizes,
                                          std::span<const double> weights = {});

/// The step that sizes were read in, such as 5 cm by tape: the largest of 1, 2, 5, 10, ... times
/// their common divisor (within 1e-6 of the largest value) of which at least nine in ten values are
/// multiples; 0 where there is none above 1e-4 of the largest.
double find_reading_resolution(std::span<const double> values);

/// How well the law fits: distance and p-value, by parametric bootstrap (`bootstrap_ks_distances`):
/// because the parameters are fitted, tables of Kolmogorov's test would flatter the law. Beyond
/// 1,000 sizes samples of 1,000 stand in, with D scaled by the root of the number of sizes.
/// @param step   of the readings, m; 0 for continuous sizes. With it, curves are compared halfway
///               between readings, where the law and the readings mean the same
/// @cite stephens1974
void test_size_law(FittedSizeLaw& law, std::span<const double> sizes, double step,
                   std::uint64_t seed, std::size_t samples = 999);

/// Distances of `samples` samples of `count` sizes, drawn from the law and read to the same `step`,
/// each from the law that is fitted to itself. Samples whose readings are all one have none.
std::vector<double> bootstrap_ks_distances(const FittedSizeLaw& law, std::size_t count, double step,
                                           std::uint64_t seed, std::size_t samples);

/// Percentiles and laws of one way to weigh blocks.
struct SizeCurve {
  std::size_t blocks = 0;
  double d10 = 0.0;  ///< m
  double d50 = 0.0;
  double d90 = 0.0;
  std::vector<FittedSizeLaw> laws;  ///< log-normal, Rosin-Rammler; empty when all sizes are equal
};

struct SizeDistribution {
  SizeMeasure measure = SizeMeasure::kIntermediate;
  double step = 0.0;    ///< of the readings, m; 0 when they are continuous
  SizeCurve by_number;  ///< percentiles linear between order statistics
  std::optional<SizeCurve>
      by_mass;  ///< of the blocks with a mass: size up to which a share of the mass lies
  double total_mass = 0.0;  ///< kg
};

/// Unscaled blocks are passed over; where all are, `by_number.blocks` is 0 and the rest empty.
/// @param population  at least one block
SizeDistribution size_distribution(const Population& population, SizeMeasure measure,
                                   std::uint64_t seed);

/// The smallest of `sizes` up to which at least `fraction` of the weight lies.
/// @param sizes, weights  of one length, not empty
double weighted_percentile(std::span<const double> sizes, std::span<const double> weights,
                           double fraction);

}  // namespace clast
