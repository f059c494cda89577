#pragma once
/// What a placed block covers of a grid of square cells in the plan.
#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::study_detail {

/// A cell that a block reaches. Cell (i, j) is x from i to i + 1 and y from j to j + 1, times the
/// width of the cells.
struct CoveredCell {
  std::int64_t i = 0, j = 0;
  double lowest = 0.0, highest = 0.0;  ///< no point of the block is below or above in this cell, m
};

/// Bounds of a block in every cell, on the safe side by up to its radius: each triangle of the core
/// is cut to the cell and the radius around it.
/// @param core   triangles of the core, closed, body frame
/// @param place  world_from_body
/// @param width  of a cell, m
std::vector<CoveredCell> compute_covered_cells(const TriangleMesh& core, double radius, const Pose& place,
                                       double width);

}  // namespace clast::study_detail
