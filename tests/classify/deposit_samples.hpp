#pragma once
/// Populations of scanned deposits with known sizes, for tests.
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "classify/population.hpp"
#include "classify/visibility_correction.hpp"
#include "core/random.hpp"
#include "core/types.hpp"

namespace clast {

/// Deposit of which the scan finds the blocks with a large enough visible area.
struct SampledDeposit {
  std::vector<Axes> truth;  ///< axes of all bodies, m
  Population found;         ///< blocks that are found, with errors of their sizes
};

struct DepositSampling {
  double mean_area = 1.0;    ///< mean visible area over I^2 at I = 0.25 m
  double slope = 0.5;        ///< its change with ln I
  double deviation = 0.6;    ///< its standard deviation
  double spacing = 0.0236;   ///< m
  double axis_error = 0.12;  ///< half width of the 90 % intervals of ln L, ln I and ln S
};

/// Draws the axes of a compact, platy, bladed, elongated or needle-shaped rock.
inline Axes draw_rock_axes(double size, Random& random) {
  struct Kind {
    double fraction, l_low, l_high, s_low, s_high;  ///< ranges of L/I and S/I
  };
  constexpr Kind kKinds[] = {{0.46, 1.02, 1.4, 0.6, 0.97},
                             {0.16, 1.05, 1.3, 0.3, 0.48},
                             {0.20, 1.35, 1.8, 0.45, 0.68},
                             {0.13, 1.6, 2.2, 0.75, 0.92},
                             {0.05, 2.5, 3.2, 0.7, 0.88}};
  double left = random.uniform();
  const Kind* kind = kKinds;
  while (left > kind->fraction && kind + 1 < std::end(kKinds)) left -= (kind++)->fraction;
  return {size * random.uniform(kind->l_low, kind->l_high), size,
          size * random.uniform(kind->s_low, kind->s_high)};
}

/// Draws estimated axes with N(larger than I) ~ 1/I^2 from 0.25 m on, and the true axes within
/// their intervals. Bodies with enough points and 12 % of their surface are found.
inline SampledDeposit sample_deposit(std::size_t count, std::uint64_t seed,
                                     const DepositSampling& sampling = {}) {
  constexpr double kSurface = 3.3;  // over I^2
  constexpr double kSmallest = 0.25;
  Random random(seed);
  SampledDeposit deposit;
  deposit.found.name = "deposit";
  while (deposit.truth.size() < count) {
    const Axes estimate = draw_rock_axes(kSmallest / std::sqrt(1.0 - random.uniform()), random);
    const auto true_side = [&](double side) {
      return side * std::exp(sampling.axis_error / 1.645 * random.normal());
    };
    const Axes axes =
        Axes::sorted(true_side(estimate.L), true_side(estimate.I), true_side(estimate.S));
    const double size = axes.I;
    deposit.truth.push_back(axes);
    const double area = sampling.mean_area + sampling.slope * std::log(size / kSmallest) +
                        sampling.deviation * random.normal();
    const double points = area * size * size / (sampling.spacing * sampling.spacing);
    if (points < VisibilityCorrection::kLeastPoints || area < 0.12 * kSurface) continue;
    MeasuredBlock block = make_measured_block("B" + std::to_string(deposit.truth.size()), estimate);
    DepositObservation seen;
    const double low = std::exp(-sampling.axis_error), high = std::exp(sampling.axis_error);
    seen.lower_axes = {estimate.L * low, estimate.I * low, estimate.S * low};
    seen.upper_axes = {estimate.L * high, estimate.I * high, estimate.S * high};
    seen.volume = 0.5 * axes.L * axes.I * axes.S;
    seen.lower_volume = seen.volume * low * low * low;
    seen.upper_volume = seen.volume * high * high * high;
    seen.points = static_cast<std::size_t>(points);
    seen.spacing = sampling.spacing;
    seen.visible_fraction = area / kSurface;
    seen.plan_area = 0.25 * kPi * axes.L * axes.I;
    seen.exposed_area = std::min(1.0, area) * seen.plan_area;
    const double azimuth = random.uniform(0.0, 2.0 * kPi);
    seen.long_axis = {std::cos(azimuth), std::sin(azimuth), 0.0};
    block.deposit = seen;
    deposit.found.blocks.push_back(block);
  }
  return deposit;
}

}  // namespace clast
