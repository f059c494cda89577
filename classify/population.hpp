#pragma once
/// Shares of shape classes in a population of blocks.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "classify/measured_block.hpp"
#include "classify/schemes.hpp"

namespace clast {

/// Blocks of one deposit, quarry or sample.
struct Population {
  std::string name;  ///< for headings and legends
  std::vector<MeasuredBlock> blocks;
};

/// Axes as written, for classes and ratios.
std::vector<Axes> axis_proportions(const Population& population);
/// kg; 0 for a block whose mass is not known.
std::vector<double> block_masses(const Population& population);

/// One class of a population. Shares are in [0, 1].
struct ClassFraction {
  std::string name;
  std::size_t count = 0;
  double fraction = 0.0;
  double low = 0.0;  ///< Wilson interval, 95 %
  double high = 0.0;
  double mass = 0.0;  ///< kg, of the blocks whose mass is known
  double mass_fraction = 0.0;
  double mass_low = 0.0;  ///< 95 %, see `class_fractions`
  double mass_high = 1.0;
};

/// Counts and shares of every class of the scheme, also of empty ones.
///
/// The interval of a share by mass is Wilson's for the number of equally heavy blocks that would be
/// as uncertain: p (1 - p) over the linearised variance of p = sum of m_i in the class / sum of
/// m_i, and at most (sum of m_i)^2 / sum of m_i^2, which alone decides for empty and full classes.
/// @param weights  mass of each block, kg, 0 where unknown; or empty, and nothing is known by mass
/// @cite wilson1927, kish1965, korn1998
std::vector<ClassFraction> class_fractions(std::span<const Axes> blocks, const std::string& scheme,
                                           const SchemeOptions& options = {},
                                           std::span<const double> weights = {});

/// Share of blocks with S/L <= 0.4.
/// @param blocks  at least one
/// @cite benn1993
double c40_index(std::span<const Axes> blocks);

}  // namespace clast
