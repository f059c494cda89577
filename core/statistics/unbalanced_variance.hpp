#pragma once
/// Variance decomposition for unbalanced designs, with missing or repeated factor combinations.
#include <cstdint>
#include <span>
#include <vector>

#include "core/statistics/variance_decomposition.hpp"

namespace clast {

/// Estimates variance components of a mixed model. The model has a mean and random effects of the
/// levels of each factor, of each pair of levels of two factors, and of each value.
///
/// The components are MINQUE(0) estimates [searle1992], which are unbiased for any design. Negative
/// ones are set to zero. Pairs that occur only once each, or that coincide with the levels of
/// another factor, have no effect of their own.
///
/// Intervals are jackknife intervals [efron1981] of the logit of a fraction. The levels of each
/// factor are left out in turn, in at most 40 groups. Squared deviations are summed over levels and
/// factors and weighted for skewed effects [bonett2006]. Student's t has Satterthwaite's degrees of
/// freedom. The coverage was verified (docs/theory.md).
/// @param outcomes  one list of values per outcome, of equal length
/// @param factors  for each factor, the level of each value
/// @return one decomposition per outcome. `design_fraction` is NaN. The interval of a factor with
///         two levels is [0, 1]. All members are zero if all values are equal
/// @throws InputError  if there is no factor or more than six, if a factor has only one level, or
///                     if list lengths differ
/// @cite searle1992 @cite efron1981 @cite bonett2006 @cite satterthwaite1946
std::vector<VarianceDecomposition> decompose_unbalanced_variance(
    std::span<const std::vector<double>> outcomes,
    std::span<const std::vector<std::uint32_t>> factors);

}  // namespace clast
