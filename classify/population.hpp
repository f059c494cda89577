#pragma once
/// Fractions of the shape classes in a population of blocks.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "classify/measured_block.hpp"
#include "classify/schemes.hpp"

namespace clast {

/// Blocks of one deposit, quarry or sample.
struct Population {
  std::string name;  ///< name for headings and legends
  std::vector<MeasuredBlock> blocks;
};

/// Returns the axes of all blocks in the units of their tables. Ratios of these axes have no
/// rounding error from a unit conversion.
std::vector<Axes> axes_for_ratios(const Population& population);
/// Returns the mass of each block, kg; 0 if unknown.
std::vector<double> block_masses(const Population& population);

/// Fraction of one class in a population, with 95 % confidence intervals.
struct ClassFraction {
  std::string name;
  std::size_t count = 0;
  double fraction = 0.0;
  double low = 0.0;  ///< lower limit of the Wilson interval
  double high = 0.0;
  double mass = 0.0;  ///< sum of the known masses, kg
  double mass_fraction = 0.0;
  double mass_low = 0.0;  ///< lower limit of the interval by mass (see `class_fractions`)
  double mass_high = 1.0;
};

/// Computes the fractions of all classes of a scheme, including empty classes.
///
/// Let p be the mass of the blocks in a class divided by the mass m_i of all blocks, and V its
/// linearised variance. The interval by mass is the Wilson interval of n = p (1 - p)/V equally
/// heavy blocks, which has the same uncertainty. n is at most (sum of m_i)^2 / sum of m_i^2, which
/// is also used for empty and full classes.
/// @param weights  mass of each block, kg, 0 if unknown; empty if no mass is known
/// @cite wilson1927, kish1965, korn1998
std::vector<ClassFraction> class_fractions(std::span<const Axes> blocks, const std::string& scheme,
                                           const SchemeOptions& options = {},
                                           std::span<const double> weights = {});

/// Returns the fraction of blocks with S/L <= 0.4 (the C40 index).
/// @param blocks  at least one block
/// @cite benn1993
double c40_index(std::span<const Axes> blocks);

}  // namespace clast
