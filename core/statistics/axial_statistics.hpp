#pragma once
/// Statistics of axial directions in a plane. The angles a and a + pi are the same axis. Doubled
/// angles are directions on the full circle.
/// @cite mardia2000
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "core/statistics/bootstrap.hpp"

namespace clast {

/// Wraps an angle to the range of axial angles.
/// @return in (-pi/2, pi/2]
double wrap_axial_angle(double angle);

struct AxialMean {
  std::size_t count = 0;
  double direction = NAN;  ///< rad, in (-pi/2, pi/2]; NaN if there is no preferred direction
  double resultant_length =
      0.0;  ///< mean resultant length of the doubled angles, 1 for parallel axes
};
/// Computes the mean direction and resultant length of axes.
/// @param angles  direction of one end of each axis, rad
AxialMean axial_mean(std::span<const double> angles);

/// Returns the p-value of Rayleigh's test of uniformity for n independent axes with mean resultant
/// length R. The modified statistic (1 - 1/(2 n)) 2 n R^2 + n R^4/2 is chi-squared with two degrees
/// of freedom to O(1/n^2).
/// @return 1 if there are no axes
double rayleigh_p_value(const AxialMean& mean);

/// Tests the uniformity of axes that are dependent within clusters, and returns the p-value. In
/// each random draw, each cluster is rotated by a random angle. p = (1 + number of draws with at
/// least the observed resultant length)/(1 + draws).
/// @param angles  rad
/// @param cluster_count  number of clusters
/// @param draws  number of random draws, positive
/// @return p-value; empty if fewer than two clusters have axes
/// @cite phipson2010
std::optional<double> clustered_rayleigh_p_value(const ClusteredValues& angles,
                                                 std::size_t cluster_count, std::uint64_t seed,
                                                 std::size_t draws = 9999);

}  // namespace clast
