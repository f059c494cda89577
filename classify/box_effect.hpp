#pragma once
/// Effect of the box convention on the shape classes of a population.
#include <span>
#include <string>
#include <vector>

#include "classify/box_convention.hpp"
#include "classify/measured_block.hpp"
#include "classify/schemes.hpp"

namespace clast {

/// Number of blocks that change class if the axes are measured by another convention.
struct BoxConventionEffect {
  BoxConvention convention = BoxConvention::kSmallest;
  std::string scheme;
  std::size_t blocks = 0;        ///< blocks that have the boxes of all conventions
  std::size_t reclassified = 0;  ///< blocks with another class
};

/// Compares the classes by each other convention with those by the axes in use, grouped by scheme.
/// Blocks without `axes_by_box` (measured by tape) are left out; the result is empty if all are.
/// @throws InputError  if a scheme is unknown
std::vector<BoxConventionEffect> compare_box_conventions(std::span<const MeasuredBlock> blocks,
                                                         std::span<const std::string> schemes,
                                                         const SchemeOptions& limits = {});

/// Formats the effect as "By the inertia box 2 of 7 blocks have another class of sneed-folk."
std::string describe_box_effect(const BoxConventionEffect& effect);

}  // namespace clast
