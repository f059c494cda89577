#pragma once
/// Filling of holes in height grids.
#include <cstddef>

#include "terrain/raw_surface.hpp"

namespace clast::terrain_detail {

/// Numbers of filled and remaining holes of a height grid.
struct HoleFillReport {
  std::size_t holes = 0;
  std::size_t cells = 0;
  std::size_t remaining = 0;            ///< number of holes wider than the limit
  double widest_remaining = 0.0;        ///< m
  Vec3 widest_position = Vec3::Zero();  ///< middle of the widest remaining hole, map coordinates
};

/// Fills holes whose bounding box is at most `max_width` (m) on each side. A hole is a set of empty
/// cells, connected over sides, that does not reach the grid's border. Filled heights satisfy the
/// discrete Laplace equation, so that planes are reproduced and heights stay in the rim's range.
HoleFillReport fill_grid_holes(HeightGrid& grid, double max_width);

}  // namespace clast::terrain_detail
