#pragma once
/// Variance decomposition for unbalanced designs, with missing or repeated factor combinations.
#include <cstdint>
#include <span>
#include <vector>

#include "core/statistics/variance_decomposition.hpp"

namespace clast {

/// Estimates variance components of a mixed model with a mean and random effects of the levels of
/// each factor, of each pair of levels of two factors, and of each value.
///
/// The components match the expected squared sums of the centred values over the levels of each
/// factor and pair: MINQUE(0) [searle1992], unbiased for any design; negative ones count as zero.
/// Pairs that occur once each, or equal the levels of another factor, have no effect of their own.
/// Intervals are jackknife intervals [efron1981]: levels of each factor are left out in turn (in
/// fortieths of them if there are more), the squared deviations of the logit of a fraction are
/// summed over levels and factors, weighted for skewed effects [bonett2006], and Student's t has
/// Satterthwaite's degrees of freedom. Their coverage was verified (docs/theory.md).
/// @param outcomes  one list of values per outcome, of equal length
/// @param factors  level of each value, for each factor
/// @return per outcome; `design_fraction` is NaN; the interval of a factor of two levels is 0 to 1;
///          all zero if all values are equal
/// @throws InputError  if there is no factor or more than six, a factor has one level, or list
///                     lengths differ
/// @cite searle1992 @cite efron1981 @cite bonett2006 @cite satterthwaite1946
std::vector<VarianceDecomposition> decompose_unbalanced_variance(
    std::span<const std::vector<double>> outcomes,
    std::span<const std::vector<std::uint32_t>> factors);

}  // namespace clast
