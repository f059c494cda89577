#pragma once
/// Bounds of mass and classes of incompletely scanned blocks.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "library/block.hpp"

namespace clast {

/// Separate bounds of L, I and S, m.
struct AxesBounds {
  Axes lower, upper;
};

/// Bounds derived from those of volume and axes.
struct BlockBracket {
  double lower_mass = 0.0;              ///< kg; equal to the upper bound for a weighed mass
  std::optional<double> upper_mass;     ///< empty if there is no upper bound
  std::optional<double> lower_density;  ///< kg/m^3; equal to the upper bound for a given density
  double upper_density = 0.0;
  std::optional<AxesBounds> axes;  ///< including the block's own axes; empty if unknown
  std::optional<double> lower_s_c, upper_s_c;
  /// Possible classes by scheme ("sneed-folk", "zingg", "garcia") for axes within their bounds;
  /// empty if the bounds are unknown.
  std::map<std::string, std::vector<std::string>> classes;
};

/// Derives the bounds of mass, density, s_c and classes of a block. The density is assumed to
/// follow from the weighed mass if volume times density equals that mass.
/// @pre the block has a volume bracket
BlockBracket derive_block_bracket(const Block& block);

/// Describes the bounds: "14 % of the surface is not seen but filled in; volume between 0.13 and
/// 0.149 m3 (best 0.137), mass ...", or that there is no upper bound. Unscaled blocks have no mass
/// and no metric units.
/// @pre  the block has a volume bracket
std::string describe_volume_bracket(const Block& block);

}  // namespace clast
