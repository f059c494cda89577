#pragma once
/// Sampling of stored trajectories at short steps, for maps and profiles.
#include <functional>

#include "dem/surface/terrain_surface.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// State of a run at one point of its trajectory, in the local frame.
struct PathSample {
  Vec3 position = Vec3::Zero();  ///< of the centre of mass, m
  double speed = 0.0;            ///< m/s
  double energy = 0.0;           ///< translational plus rotational kinetic energy, J
  double height = 0.0;  ///< of the centre of mass above the ground, m; NaN outside the terrain
};

/// Visits the stored frames of a trajectory and interpolated points between them. The horizontal
/// distance of successive points is at most `step`. Positions are interpolated by the cubic Hermite
/// spline of the stored positions and velocities, which is exact in free flight. Velocity and
/// rotational energy are interpolated linearly.
/// @param block  gives mass and inertia for the energies
/// @param step  m, positive
void for_each_path_sample(const Trajectory& trajectory, const BlockSummary& block,
                          const TerrainSurface& ground, double step,
                          const std::function<void(const PathSample&)>& visit);

/// Visits each stored trajectory of a comparison, in the order of its rows.
void for_each_trajectory(
    const Comparison& comparison,
    const std::function<void(std::size_t row, const Trajectory&, const TerrainSurface&)>& visit);

}  // namespace clast
