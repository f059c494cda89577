#pragma once
/// What an unseen side leaves open of a block's mass and classes.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "library/block.hpp"

namespace clast {

/// Bounds of L, I and S, each by itself, m.
struct AxesBounds {
  Axes lower, upper;
};

/// Bounds that follow from those of volume and axes.
struct BlockBracket {
  double lower_mass = 0.0;              ///< kg; a weighed mass has no width
  std::optional<double> upper_mass;     ///< none: no upper bound can be given
  std::optional<double> lower_density;  ///< kg/m^3; a density given has no width
  double upper_density = 0.0;
  std::optional<AxesBounds> axes;  ///< the block's own axes included; none: not known
  std::optional<double> lower_s_c, upper_s_c;
  /// By scheme ("sneed-folk", "zingg", "garcia"): every class that axes within their bounds have,
  /// each axis by itself. Empty where the axes are not known.
  std::map<std::string, std::vector<std::string>> classes;
};

/// @pre  `block.volume_bracket` is there. The density is taken as derived from the weighed mass
/// where volume and density give that mass.
BlockBracket derive_block_bracket(const Block& block);

/// "14 % of the surface is not seen but filled in; volume between 0.13 and 0.149 m3 (best 0.137),
/// mass ...", or that no upper bound can be given. An unscaled block has no mass, and its volume no
/// metres.
/// @pre  `block.volume_bracket` is there
std::string describe_volume_bracket(const Block& block);

}  // namespace clast
