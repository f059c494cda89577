#pragma once
/// Test if an outcome rises or falls monotonically with a property of the observed units.
#include <cstdint>
#include <optional>
#include <vector>

#include "core/statistics/sample_tests.hpp"

namespace clast {

/// Values that are tested for a rise or fall with a property of the blocks. Each value belongs to a
/// unit (block), which has the property, and to a cluster (release point).
struct TrendSample {
  std::vector<double> values;
  std::vector<std::uint32_t> clusters;  ///< one per value
  std::vector<std::uint32_t> units;     ///< one per value, below the number of units
  std::vector<double> property;         ///< one per unit
  /// Stratum of each unit. Under the null hypothesis, properties are exchangeable within strata.
  std::vector<std::uint32_t> strata;
};

/// Tests if values rise or fall with the property of their units (Page's test).
///
/// Values are ranked within their cluster, which removes cluster effects. Then the mean rank of
/// each unit is computed. The statistic is the correlation of property ranks and mean ranks within
/// strata, pooled over the strata. For one stratum it is Spearman's rho; for several it is Page's L
/// scaled to [-1, 1].
///
/// The two-sided p-value comes from permutations of the property between the units of a stratum.
/// Values may therefore be dependent within units and clusters. The p-value is exact if all units
/// have the same clusters. For one stratum of up to nine units, all permutations are used.
/// Otherwise p = (1 + number of at least as extreme draws)/(1 + draws).
/// @param draws  number of random permutations, positive
/// @return empty if fewer than three units are in strata with different properties, or if all mean
///         ranks are equal
/// @throws InputError  if list lengths differ or a unit index is invalid
/// @cite page1963 @cite spearman1904 @cite phipson2010
std::optional<TestResult> clustered_trend_test(const TrendSample& sample, std::uint64_t seed,
                                               std::size_t draws = 9999);

}  // namespace clast
