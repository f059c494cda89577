#pragma once
/// Bounds of mass, density and shape classes of incompletely scanned blocks.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "library/block.hpp"

namespace clast {

/// Lower and upper bounds of the axes L, I and S, m.
struct AxesBounds {
  Axes lower, upper;
};

/// Bounds of mass, density and shape classes, derived from a volume bracket.
struct BlockBracket {
  double lower_mass = 0.0;           ///< kg; equal to the upper bound if the block was weighed
  std::optional<double> upper_mass;  ///< empty if there is no upper bound
  std::optional<double>
      lower_density;  ///< kg/m^3; equal to the upper bound if the density is given
  double upper_density = 0.0;
  std::optional<AxesBounds> axes;  ///< bounds that include the axes of the block; empty if unknown
  std::optional<double> lower_s_c, upper_s_c;
  /// Possible classes of axes within their 90 % intervals, or within their bounds if there are no
  /// intervals, by scheme ("sneed-folk", "zingg", "garcia"). Empty if the bounds are unknown.
  std::map<std::string, std::vector<std::string>> classes;
};

/// Derives the bounds of mass, density and classes of a block. If volume times density equals the
/// weighed mass, the density is taken to follow from this mass.
/// @pre the block has a volume bracket
BlockBracket derive_block_bracket(const Block& block);

/// Describes the bounds, such as "14 % of the surface is not seen but filled in; volume between
/// 0.13 and 0.149 m3 (best 0.137), mass ...". Mass and metric units are omitted for unscaled
/// blocks.
/// @pre  the block has a volume bracket
std::string describe_volume_bracket(const Block& block);

}  // namespace clast
