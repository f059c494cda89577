#pragma once
/// Test of a monotone trend of an outcome with a property of the observed units.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/statistics/sample_tests.hpp"

namespace clast {

/// Values of units (blocks), observed in clusters (release points) shared by the units.
struct TrendSample {
  std::vector<double> values;
  std::vector<std::uint32_t> clusters;  ///< one per value
  std::vector<std::uint32_t> units;     ///< one per value, below the number of units
  std::vector<double> property;         ///< one per unit
  /// Stratum of each unit; under the null hypothesis, properties are exchangeable within strata.
  std::vector<std::uint32_t> strata;
};

/// Page's trend test on units.
///
/// Values are ranked within their cluster, which removes cluster effects, and the mean rank of each
/// unit is computed. The statistic is the correlation of property ranks and mean ranks within
/// strata, pooled over strata: Spearman's rho for one stratum, Page's L scaled to [-1, 1] for
/// several. The two-sided p-value is from permutations of the property between the units of a
/// stratum, so that values may be dependent within units and clusters; it is exact if all units
/// have the same clusters. All permutations are used for one stratum of up to nine units, otherwise
/// p = (1 + at least as extreme)/(1 + draws).
/// @param draws  positive
/// @return empty if no stratum has units with different properties, fewer than three units have, or
///          all mean ranks are equal
/// @throws InputError  if list lengths differ or a unit index is invalid
/// @cite page1963 @cite spearman1904 @cite phipson2010
std::optional<TestResult> clustered_trend_test(const TrendSample& sample, std::uint64_t seed,
                                               std::size_t draws = 9999);

}  // namespace clast
