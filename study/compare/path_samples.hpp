#pragma once
/// The way of a run over the ground, in steps short enough for maps and profiles.
#include <functional>

#include "dem/surface/terrain_surface.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// A run at one place of its way. Local frame.
struct PathSample {
  Vec3 position = Vec3::Zero();  ///< of the centre, m
  double speed = 0.0;            ///< m/s
  double energy = 0.0;           ///< translational and rotational, J
  double height = 0.0;           ///< of the centre above the ground under it, m; NaN off the survey
};

/// Visits a stored trajectory at its frames and between them, no farther apart in plan than
/// `spacing`. Between frames the centre moves on the cubic that their places and velocities give
/// (exact in flight), and velocity and rotational energy change evenly.
/// @param block  of the run, for its energies
/// @param step  m, positive
void walk(const Trajectory& trajectory, const BlockSummary& block, const TerrainSurface& ground,
          double step, const std::function<void(const PathSample&)>& visit);

/// Visits every stored trajectory of a comparison, in order of its rows.
void for_each_trajectory(
    const Comparison& comparison,
    const std::function<void(std::size_t row, const Trajectory&, const TerrainSurface&)>& visit);

}  // namespace clast
