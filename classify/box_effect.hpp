#pragma once
/// How far a population's classes depend on the box that L, I and S were measured on.
#include <span>
#include <string>
#include <vector>

#include "classify/box_convention.hpp"
#include "classify/measured_block.hpp"
#include "classify/schemes.hpp"

namespace clast {

/// Blocks whose class by one convention is not the class by the axes in use.
struct BoxConventionEffect {
  BoxConvention convention = BoxConvention::kSmallest;
  std::string scheme;
  std::size_t blocks = 0;  ///< with boxes by all conventions
  std::size_t reclassified = 0;
};

/// Conventions within schemes, schemes in the order given; without the convention whose axes are in
/// use. Blocks without `axes_by_box` (rows of tape tables) are left out; empty where all are.
/// @throws InputError  unknown scheme
std::vector<BoxConventionEffect> compare_box_conventions(std::span<const MeasuredBlock> blocks,
                                                         std::span<const std::string> schemes,
                                                         const SchemeOptions& limits = {});

/// "By the inertia box 2 of 7 blocks have another class of sneed-folk."
std::string describe_box_effect(const BoxConventionEffect& effect);

}  // namespace clast
