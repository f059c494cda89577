#pragma once
/// Areas of bodies in plan, and the parts of them that are seen from above.
#include <span>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Area of a body in plan.
struct PlanCover {
  double area = 0.0;     ///< m^2
  double exposed = 0.0;  ///< part of `area` above which there is no other body, m^2
};

/// Computes the areas of closed bodies in plan, z up, on a grid of square cells.
///
/// The cells are a fortieth of the square root of the median area of the bodies' bounding boxes,
/// or larger, so that there are at most four million. A body covers a cell if it is above or below
/// its centre.
/// @return one entry per body
std::vector<PlanCover> measure_plan_cover(std::span<const TriangleMesh* const> bodies);

}  // namespace clast
