#pragma once
/// Filling of holes in height grids.
#include <cstddef>

#include "terrain/raw_surface.hpp"

namespace clast::terrain_detail {

struct HoleFillReport {
  std::size_t holes = 0;
  std::size_t cells = 0;
  std::size_t remaining = 0;            ///< holes that are wider
  double widest_remaining = 0.0;        ///< m
  Vec3 widest_position = Vec3::Zero();  ///< middle of the widest that is left, on the map
};

/// Fills holes whose bounding box is at most `widest` (m) on each side. A hole is a set of
/// side-connected empty cells that does not reach the border. Filled heights satisfy the discrete
/// Laplace equation (membrane): planes are reproduced, and no height exceeds the rim.
HoleFillReport fill_holes(HeightGrid& grid, double widest);

}  // namespace clast::terrain_detail
