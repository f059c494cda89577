#pragma once
/// Sphere in ballistic flight, which contains a tumbling block.
#include "dem/surface/indexed_surface.hpp"

namespace clast::dem_detail {

struct BallisticSphere {
  Vec3 centre = Vec3::Zero();    ///< present position
  Vec3 velocity = Vec3::Zero();  ///< present velocity, m/s
  double gravity = 0.0;          ///< m/s^2, along -z
  double radius = 0.0;           ///< m
};

/// Returns a lower bound of the flight time until the sphere touches the ground, s; 0 if contact is
/// possible at once. It follows from the height ranges of the grid cells along the path.
/// @param longest  time limit of the search, s
double ballistic_contact_free_time(const PlanGrid& grid, const BallisticSphere& ball,
                                   double longest);

}  // namespace clast::dem_detail
