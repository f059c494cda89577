#pragma once
/// How finely a file keeps coordinates.
#include <optional>

#include "shapes/triangle_mesh.hpp"

namespace clast::detail {

struct CoordinateStep {
  double step = 0.0;     ///< the coarsest distance of neighbouring numbers over the axes
  double largest = 0.0;  ///< the largest coordinate, where that step is
};

/// The step that all coordinates of an axis are multiples of because they were stored as 32-bit
/// floats or written with seven digits. None: some coordinate has more digits than that.
std::optional<CoordinateStep> coordinate_step(const TriangleMesh& mesh);

}  // namespace clast::detail
