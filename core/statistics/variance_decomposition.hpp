#pragma once
/// What share of the variance of a quantity goes with each factor of a crossed design.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/statistics/statistics.hpp"

namespace clast {

/// The share of one factor, or of all interactions together.
struct VarianceFraction {
  /// Of the levels as they are: the first-order Sobol index of the design, exactly.
  double design_fraction = 0.0;
  /// Of the population that the levels were drawn from.
  double estimate = 0.0;
  Interval interval;  ///< 95 %, of the estimate
};

struct VarianceDecomposition {
  double variance = 0.0;                  ///< estimate, of a value at levels drawn anew
  std::vector<VarianceFraction> factors;  ///< alone, in the order of the design
  VarianceFraction interactions;          ///< of two and more factors
};

/// Shares of the variance in a full factorial design with one value for each combination.
///
/// The sum of squares splits exactly into those of the factors and of their interactions; over the
/// total, those are Sobol's indices of the design [sobol2001]. Estimates are the variance
/// components of the model in which the levels of every factor are drawn by chance, from the mean
/// squares [searle1992], negative ones taken as zero. Intervals are generalised confidence
/// intervals [weerahandi1993]: mean squares are drawn 2,000 times as degrees of freedom times the
/// one found over a chi-squared number. They are exact for normal effects in large samples and have
/// been shown to cover (docs/theory.md).
/// @param values  the last factor's level changes fastest
/// @param levels  of each factor, two or more; their product is the number of values
/// @return all zero where all values are equal
/// @throws InputError  no factor or more than six, a factor of one level, or not as many values
///                     as combinations
/// @cite sobol2001 @cite searle1992 @cite weerahandi1993
VarianceDecomposition decompose_variance(std::span<const double> values,
                                         std::span<const std::size_t> levels,
                                         std::uint64_t seed = 1);

}  // namespace clast
