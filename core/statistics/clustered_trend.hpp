#pragma once
/// Does an outcome rise or fall with a property of the units that it was observed on?
#include <cstdint>
#include <optional>
#include <vector>

#include "core/statistics/sample_tests.hpp"

namespace clast {

/// Values of units (blocks), observed in clusters (release points) that all or many units meet.
struct TrendSample {
  std::vector<double> values;
  std::vector<std::uint32_t> clusters;  ///< of each value
  std::vector<std::uint32_t> units;     ///< of each value, below the number of units
  std::vector<double> property;         ///< of each unit
  /// Of each unit: its property could as well be that of another unit of the stratum.
  std::vector<std::uint32_t> strata;
};

/// Page's test of a monotone trend, on units.
///
/// Values are ranked within their cluster, so that what a cluster does to all of its values has no
/// influence, and the mean rank of each unit is taken. With ranks of property and mean rank within
/// each stratum, the statistic is the correlation of both, pooled over strata: Spearman's where
/// there is one stratum, and Page's L, scaled to [-1, 1], where there are several. p is two-sided,
/// from exchanges of the property between the units of a stratum: all values of a unit stay
/// together, so neither those of a unit nor those of a cluster need be independent of each other.
/// It is exact where every unit has the same clusters: all orders of one stratum of up to nine
/// units, else (1 + as far)/(1 + draws).
/// @param draws  positive
/// @return none where no stratum has units with different properties, or fewer than three units do,
///         or all mean ranks are equal
/// @throws InputError  lists of different lengths, or a unit that is not there
/// @cite page1963 @cite spearman1904 @cite phipson2010
std::optional<TestResult> clustered_trend_test(const TrendSample& sample, std::uint64_t seed,
                                          std::size_t draws = 9999);

}  // namespace clast
