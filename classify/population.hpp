#pragma once
/// Shares of shape classes in a population of blocks.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "classify/schemes.hpp"

namespace clast {

/// One class of a population. Shares are in [0, 1].
struct ClassShare {
  std::string name;
  std::size_t count = 0;
  double share = 0.0;
  double low = 0.0;  ///< Wilson interval, 95 %
  double high = 0.0;
};

/// Counts and shares of every class of the scheme, also of empty ones.
/// @cite wilson1927
std::vector<ClassShare> class_shares(std::span<const Axes> blocks, const std::string& scheme);

}  // namespace clast
