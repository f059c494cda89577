#pragma once
/// Contact-free flight time of a bounding sphere, which contains all motion of a tumbling block.
#include "dem/surface/indexed_surface.hpp"

namespace clast::dem_detail {

struct BallisticSphere {
  Vec3 centre = Vec3::Zero();    ///< present position
  Vec3 velocity = Vec3::Zero();  ///< present velocity, m/s
  double gravity = 0.0;          ///< m/s^2, along -z
  double radius = 0.0;           ///< m
};

/// Returns a time during which the ball touches no ground triangle, s; 0 if contact is possible at
/// once. It uses the height ranges of the plan grid along the path, so that it is shorter than
/// exact by the relief within a cell. It ends at cells without ground.
/// @param longest  s: longer times are not searched
double ballistic_contact_free_time(const PlanGrid& grid, const BallisticSphere& ball,
                                   double longest);

}  // namespace clast::dem_detail
