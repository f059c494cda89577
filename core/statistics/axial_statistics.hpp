#pragma once
/// Statistics of axial directions in a plane, where a and a + pi are equal. Angles are doubled to
/// directions on the full circle.
/// @cite mardia2000
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "core/statistics/bootstrap.hpp"

namespace clast {

/// Wraps an angle to that of an axis.
/// @return in (-pi/2, pi/2]
double wrap_axial_angle(double angle);

struct AxialMean {
  std::size_t count = 0;
  double direction = NAN;  ///< rad, in (-pi/2, pi/2]; NaN without a preferred direction
  double resultant = 0.0;  ///< mean resultant length of the doubled angles: 0 uniform, 1 parallel
};
/// Computes the axial mean.
/// @param angles  rad, of one end of each axis
AxialMean axial_mean(std::span<const double> angles);

/// Returns the p-value of Rayleigh's test of uniformity for independent axes, from the modified
/// statistic (1 - 1/(2 n)) 2 n R^2 + n R^4/2, chi-squared with two degrees of freedom to O(1/n^2).
/// @return 1 without axes
double rayleigh_p_value(const AxialMean& mean);

/// Returns the p-value for axes dependent within clusters: each cluster is rotated by a random
/// angle; p = (1 + number of resultants at least as large)/(1 + draws).
/// @param angles  rad
/// @param clusters  number of clusters
/// @param draws  positive
/// @return empty if fewer than two clusters have axes
/// @cite phipson2010
std::optional<double> clustered_rayleigh_p_value(const ClusteredValues& angles,
                                                 std::size_t clusters, std::uint64_t seed,
                                                 std::size_t draws = 9999);

}  // namespace clast
