#pragma once
/// Cells without a height inside a grid.
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

/// Fills the holes of a grid that are at most `widest` long and wide (the box around them, m). A
/// hole is a set of empty cells joined over their sides that does not reach the border of the grid.
/// It gets the heights whose every cell is the mean of its four neighbours (in the metric of the
/// cells): a membrane, which leaves a plane as it is and rises or sinks nowhere beyond the rim.
HoleFillReport fill_holes(HeightGrid& grid, double widest);

}  // namespace clast::terrain_detail
