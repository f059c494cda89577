#pragma once
/// Effect of the box convention on the shape classes of a population.
#include <span>
#include <string>
#include <vector>

#include "classify/box_convention.hpp"
#include "classify/measured_block.hpp"
#include "classify/schemes.hpp"

namespace clast {

/// Number of blocks whose class changes if another box convention is used.
struct BoxConventionEffect {
  BoxConvention convention = BoxConvention::kSmallest;
  std::string scheme;
  std::size_t blocks = 0;        ///< number of blocks with the boxes of all conventions
  std::size_t reclassified = 0;  ///< number of blocks with another class
};

/// Compares the classes of blocks for the axes in use with those for each other box convention.
/// Results are grouped by scheme. Blocks without `axes_by_box`, which were measured by tape, are
/// omitted. The result is empty if all blocks are omitted.
/// @throws InputError  if a scheme is unknown
std::vector<BoxConventionEffect> compare_box_conventions(std::span<const MeasuredBlock> blocks,
                                                         std::span<const std::string> schemes,
                                                         const SchemeOptions& limits = {});

/// Formats an effect as "By the inertia box 2 of 7 blocks have another class of sneed-folk."
std::string describe_box_convention_effect(const BoxConventionEffect& effect);

}  // namespace clast
