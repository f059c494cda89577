#pragma once
/// Trajectories of blocks that were observed in the field.
#include <filesystem>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::study_detail {

/// State of a block at one time, observed in the field.
struct TrajectoryPoint {
  double time = 0.0;  ///< time since the release, s
  Vec2 position = Vec2::Zero();
  double speed = 0.0;  ///< speed of the centre of mass, m/s
  double spin = 0.0;   ///< angular speed, rad/s
};

/// Observed trajectory: states in ascending order of time, from the release.
using ObservedTrajectory = std::vector<TrajectoryPoint>;

struct ObservedTrajectorySet {
  std::string sha256;  ///< digest of the table
  std::vector<ObservedTrajectory> all;

  double longest() const;  ///< duration of the longest trajectory, s
};

/// Reads a table with columns trajectory, time_s, x_m, y_m, speed_m_s and spin_rad_s. Rows with
/// equal trajectory number form a trajectory; its first row is the release.
/// @throws InputError  if there is no such table, or times do not increase; names file and line
ObservedTrajectorySet read_trajectories(const std::filesystem::path& file);

/// Interpolates an observed trajectory linearly. After its last point, the state is constant.
/// @param time  time since the release, s
TrajectoryPoint interpolate_trajectory(const ObservedTrajectory& trajectory, double time);

}  // namespace clast::study_detail
