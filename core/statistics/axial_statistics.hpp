#pragma once
/// Statistics of axes in a plane: lines without a head, so that a and a + pi are one direction.
/// Angles are doubled, which makes them directions on the whole circle.
/// @cite mardia2000
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "core/statistics/bootstrap.hpp"

namespace clast {

/// An angle as that of an axis.
/// @return in (-pi/2, pi/2]
double wrap_axial_angle(double angle);

struct AxialMean {
  std::size_t count = 0;
  double direction = NAN;  ///< rad, in (-pi/2, pi/2]; not a number where nothing is preferred
  double resultant = 0.0;  ///< mean length of the doubled angles' unit vectors: 0 even, 1 parallel
};
/// @param angles  rad, of one end of each axis
AxialMean axial_mean(std::span<const double> angles);

/// Rayleigh's test: the probability of a resultant so long where all directions are as likely, for
/// independent axes; by the modified statistic (1 - 1/(2 n)) 2 n R^2 + n R^4/2, chi-squared with
/// two degrees of freedom to O(1/n^2).
/// @return 1 without axes
double rayleigh_p_value(const AxialMean& mean);

/// The same where axes of one cluster depend on each other: each cluster is turned as a whole by an
/// angle at random, as often as `draws`; p = (1 + as long)/(1 + draws).
/// @param angles    rad
/// @param clusters  how many there are
/// @param draws     positive
/// @return none where fewer than two clusters have axes
/// @cite phipson2010
std::optional<double> clustered_rayleigh_p_value(const ClusteredValues& angles, std::size_t clusters,
                                             std::uint64_t seed, std::size_t draws = 9999);

}  // namespace clast
