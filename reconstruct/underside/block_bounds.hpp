#pragma once
/// How large and how small the block of a scan may be.
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// Bounds of the sides of the smallest box, each by itself: L, I, S in m.
struct SideBounds {
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();
};

/// What holes, gaps between points, noise and copies of the surface leave open of a block.
struct BlockBounds {
  double lower_volume = 0.0;           ///< m^3
  double best_volume = 0.0;            ///< of the closed surface, m^3
  std::optional<double> upper_volume;  ///< none: too large a part of the block was not seen, m^3
  std::optional<SideBounds> sides;     ///< none: nothing is known of the sides
  double invented_share = 0.0;         ///< of the surface
  std::string assumption;              ///< behind the bounds, in words; empty: they have none
  std::vector<std::string> notes;      ///< on what may be behind the unseen parts, for the scan's
};

}  // namespace clast
