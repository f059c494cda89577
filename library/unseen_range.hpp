#pragma once
/// What an unseen side leaves open of a block's mass and classes.
#include <map>
#include <string>
#include <vector>

#include "library/block.hpp"

namespace clast {

/// Bounds that the shapes between the lower and the upper one have.
struct UnseenRange {
  double lower_mass = 0.0, upper_mass = 0.0;        ///< kg; a weighed mass has no width
  double lower_density = 0.0, upper_density = 0.0;  ///< kg/m^3; a density given has no width
  double lower_s_c = 0.0, upper_s_c = 0.0;
  /// By scheme ("sneed-folk", "zingg", "garcia"): classes met from the lower to the upper box, the
  /// block's own included.
  std::map<std::string, std::vector<std::string>> classes;
};

/// @pre  `block.unseen` is there. The density is taken as derived from the weighed mass where
/// volume and density give that mass.
UnseenRange unseen_range(const Block& block);

/// "14 % of the surface is not seen but filled in; volume between 0.13 and 0.149 m3 (best 0.137),
/// mass ...". An unscaled block has no mass, and its volume no metres.
/// @pre  `block.unseen` is there
std::string described_unseen(const Block& block);

}  // namespace clast
