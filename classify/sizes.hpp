#pragma once
/// How large the blocks of a population are, and whether that goes with their shape.
#include <optional>
#include <span>

#include "classify/form.hpp"

namespace clast {

/// (L I S)^(1/3), m: the edge of the cube of equal box.
double nominal_diameter(const Axes& axes);

/// A distribution fitted to sizes by maximum likelihood.
struct SizeFit {
  double scale = 0.0;     ///< m: the median of the log-normal, the size d' of Rosin-Rammler that
                          ///< 1/e of the blocks exceed
  double spread = 0.0;    ///< standard deviation of ln d; exponent n of Rosin-Rammler
  double distance = 0.0;  ///< largest between fitted and counted distribution: Kolmogorov-Smirnov
};

/// Nominal diameters of a population, m. Fits are by number and need two different sizes.
struct SizeDistribution {
  double d10 = 0.0, d50 = 0.0, d90 = 0.0;              ///< by number
  std::optional<double> mass_d10, mass_d50, mass_d90;  ///< by mass, where every block has one
  std::optional<SizeFit> log_normal;
  std::optional<SizeFit> rosin_rammler;  ///< share larger than d: exp(-(d/d')^n)
};

/// @param blocks  at least one
/// @cite rosin1933
SizeDistribution size_distribution(std::span<const Axes> blocks,
                                   std::span<const double> masses = {});

/// Spearman's rank correlation of nominal diameter and form; none for fewer than three blocks.
struct SizeAndShape {
  double s_c = 0.0;
  double s_l = 0.0;             ///< S/L
  double disc_rod_index = 0.0;  ///< over the blocks with L > S
};
std::optional<SizeAndShape> size_and_shape(std::span<const Axes> blocks);

}  // namespace clast
