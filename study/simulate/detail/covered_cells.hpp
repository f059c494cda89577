#pragma once
/// Plan grid cells covered by a placed block.
#include <cstdint>
#include <vector>

#include "core/pose.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::study_detail {

/// Cell covered by a block. Cell (i, j) spans x from i to i + 1 and y from j to j + 1, times the
/// cell width.
struct CoveredCell {
  std::int64_t i = 0, j = 0;
  double lowest = 0.0, highest = 0.0;  ///< bounds of the block's height in this cell, m
};

/// Computes conservative height bounds of a block in each covered cell, at most `radius` too wide:
/// each core triangle is clipped to the cell enlarged by the radius.
/// @param core  closed triangles of the core, body frame
/// @param place  world_from_body
/// @param width  of a cell, m
std::vector<CoveredCell> compute_covered_cells(const TriangleMesh& core, double radius,
                                               const Pose& place, double width);

}  // namespace clast::study_detail
