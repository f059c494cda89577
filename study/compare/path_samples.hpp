#pragma once
/// Sampling of stored trajectories at short steps, for maps and profiles.
#include <functional>

#include "dem/surface/terrain_surface.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// State of a run at one point of its trajectory, in the local frame.
struct PathSample {
  Vec3 position = Vec3::Zero();  ///< position of the centre of mass, m
  double speed = 0.0;            ///< m/s
  double energy = 0.0;           ///< translational plus rotational kinetic energy, J
  /// Height of the centre of mass above the ground, m; NaN outside the terrain.
  double height = 0.0;
};

/// Visits the stored states of a trajectory and interpolated points between them. Positions are
/// interpolated by cubic Hermite splines, which are exact in free flight.
/// @param block  block of the run, which gives mass and inertia
/// @param step  largest horizontal distance of successive points, m
void for_each_path_sample(const Trajectory& trajectory, const BlockSummary& block,
                          const TerrainSurface& ground, double step,
                          const std::function<void(const PathSample&)>& visit);

/// Visits each stored trajectory of a comparison, in the order of its rows.
void for_each_trajectory(
    const Comparison& comparison,
    const std::function<void(std::size_t row, const Trajectory&, const TerrainSurface&)>& visit);

}  // namespace clast
