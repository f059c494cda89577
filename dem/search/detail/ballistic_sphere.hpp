#pragma once
/// How long a ball flies before it can touch the ground: what a block does, whichever way it
/// tumbles, happens inside its bounding ball.
#include "dem/surface/indexed_surface.hpp"

namespace clast::dem_detail {

/// A ball on a ballistic path.
struct BallisticSphere {
  Vec3 centre = Vec3::Zero();    ///< now
  Vec3 velocity = Vec3::Zero();  ///< now, m/s
  double gravity = 0.0;          ///< m/s^2, along -z
  double radius = 0.0;           ///< m
};

/// A time in which the ball touches no triangle of the ground, s; 0 when it might do so at once.
/// From the height ranges of the plan grid alone, cell by cell along the path, so that it is too
/// short by about what the ground rises within a cell. It ends at the latest where the centre comes
/// to a cell without ground.
/// @param longest  s: a longer time is not searched for
double ballistic_contact_free_time(const PlanGrid& grid, const BallisticSphere& ball,
                                   double longest);

}  // namespace clast::dem_detail
