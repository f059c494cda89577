#pragma once
/// Variance decomposition of full factorial designs.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {

/// Variance fraction of one factor, or of all interactions.
struct VarianceFraction {
  /// Fraction of the variance of the given values: the first-order Sobol index of the design.
  double design_fraction = 0.0;
  /// Estimated variance fraction in the population from which the levels were drawn.
  double estimate = 0.0;
  Interval interval;  ///< 95 % interval of `estimate`
};

struct VarianceDecomposition {
  double variance = 0.0;                  ///< estimated variance of a value at newly drawn levels
  std::vector<VarianceFraction> factors;  ///< main effects, in the order of the design
  VarianceFraction interactions;          ///< all interactions of two and more factors
};

/// Decomposes the variance of a full factorial design with one value per combination.
///
/// The sum of squares splits exactly into parts of the factors and of the interactions. Divided by
/// the total, they are the Sobol indices of the design [sobol2001]. Estimates are variance
/// components of the random-effects model from the mean squares [searle1992]; negative ones are set
/// to zero. Intervals are generalised confidence intervals [weerahandi1993] from 2,000 random draws
/// of the mean squares. They are exact for normal effects in large samples; their coverage was
/// verified (docs/theory.md).
/// @param values  one per combination; the level of the last factor varies fastest
/// @param levels  number of levels per factor, at least two; their product is the number of values
/// @return decomposition; all members are zero if all values are equal
/// @throws InputError  if there is no factor or more than six, if a factor has only one level, or
///                     if the sizes differ
/// @cite sobol2001 @cite searle1992 @cite weerahandi1993
VarianceDecomposition decompose_variance(std::span<const double> values,
                                         std::span<const std::size_t> levels,
                                         std::uint64_t seed = 1);

}  // namespace clast
