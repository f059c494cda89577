#pragma once
/// Cells of a plan grid that a placed block covers.
#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::study_detail {

/// Grid cell that a block covers. Cell (i, j) extends from i to i + 1 in x and from j to j + 1 in
/// y, in units of the cell width.
struct CoveredCell {
  std::int64_t i = 0, j = 0;
  double lowest = 0.0, highest = 0.0;  ///< bounds of the block's height in this cell, m
};

/// Computes the cells that a block covers, with bounds of the height of the block in each. The
/// bounds exceed the exact ones by at most `radius`.
/// @param core  closed surface of the core, body frame
/// @param place  pose of the block, world_from_body
/// @param width  width of a cell, m
std::vector<CoveredCell> compute_covered_cells(const TriangleMesh& core, double radius,
                                               const Pose& place, double width);

}  // namespace clast::study_detail
