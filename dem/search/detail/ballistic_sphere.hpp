#pragma once
/// Contact-free flight time of the bounding sphere of a tumbling block.
#include "dem/surface/indexed_surface.hpp"

namespace clast::dem_detail {

struct BallisticSphere {
  Vec3 centre = Vec3::Zero();    ///< present position
  Vec3 velocity = Vec3::Zero();  ///< present velocity, m/s
  double gravity = 0.0;          ///< m/s^2, along -z
  double radius = 0.0;           ///< m
};

/// Returns a lower bound of the time until the sphere touches a ground triangle, s; 0 if contact is
/// possible at once. It is computed from the height ranges of the grid cells along the path. The
/// search ends at a cell without ground.
/// @param longest  largest time searched, s
double ballistic_contact_free_time(const PlanGrid& grid, const BallisticSphere& ball,
                                   double longest);

}  // namespace clast::dem_detail
