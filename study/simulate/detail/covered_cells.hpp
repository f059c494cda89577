#pragma once
/// Cells of a plan grid that a placed block covers.
#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::study_detail {

/// Cell covered by a block. In units of the cell width, cell (i, j) extends in x from i to i + 1
/// and in y from j to j + 1.
struct CoveredCell {
  std::int64_t i = 0, j = 0;
  double lowest = 0.0, highest = 0.0;  ///< bounds of the block's height in this cell, m
};

/// Computes conservative bounds of the height of a block in each covered cell. They exceed the
/// exact ones by at most `radius`, because core triangles are clipped to enlarged cells.
/// @param core  closed surface of the core, body frame
/// @param place  world_from_body
/// @param width  width of a cell, m
std::vector<CoveredCell> compute_covered_cells(const TriangleMesh& core, double radius,
                                               const Pose& place, double width);

}  // namespace clast::study_detail
