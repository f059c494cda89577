#pragma once
/// What share of the variance of quantities goes with each factor where some combinations of their
/// levels are missing, or come more than once.
#include <cstdint>
#include <span>
#include <vector>

#include "core/statistics/variance_decomposition.hpp"

namespace clast {

/// Estimates in the mixed model: a mean, and effects drawn by chance of the levels of every factor,
/// of every pair of levels of two factors, and of every value.
///
/// The components of the variance are those for which the squared sums of the values less their
/// mean, over the levels of each factor and pair, are as expected: MINQUE(0) [searle1992], without
/// bias whatever combinations there are; negative ones count as zero. Pairs that come once each, or
/// are the levels of another factor, are no effects of their own. Intervals are of the jackknife
/// [efron1981]: each level of a factor is left out in turn (by fortieths of them where there are
/// more), the squared deviations of the logarithm of the odds of a share are added over the levels
/// and over the factors, more of those of a factor whose effects are skewed [bonett2006], and
/// Student's t has Satterthwaite's degrees of freedom. They have been shown to cover
/// (docs/theory.md).
/// @param outcomes  one list of values for each; all of one length
/// @param factors   the level of each value, for each factor
/// @return for each outcome; `design_fraction` is not a number; a factor of two levels has the
/// interval 0
///         to 1; all zero where all values are equal
/// @throws InputError  no factor or more than six, one of one level, or lists of different lengths
/// @cite searle1992 @cite efron1981 @cite bonett2006 @cite satterthwaite1946
std::vector<VarianceDecomposition> decompose_unbalanced_variance(
    std::span<const std::vector<double>> outcomes,
    std::span<const std::vector<std::uint32_t>> factors);

}  // namespace clast
