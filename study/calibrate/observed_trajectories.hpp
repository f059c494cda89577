#pragma once
/// Trajectories of blocks that were observed in the field.
#include <filesystem>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::study_detail {

/// State of an observed block at one time.
struct TrajectoryPoint {
  double time = 0.0;  ///< since the release, s
  Vec2 position = Vec2::Zero();
  double speed = 0.0;  ///< of the centre of mass, m/s
  double spin = 0.0;   ///< rad/s
};

/// Points in ascending time order, from the release.
using ObservedTrajectory = std::vector<TrajectoryPoint>;

struct ObservedTrajectorySet {
  std::string sha256;  ///< of the table
  std::vector<ObservedTrajectory> all;

  double longest() const;  ///< duration of the longest trajectory, s
};

/// Reads a table with columns trajectory, time_s, x_m, y_m, speed_m_s and spin_rad_s. Rows with
/// equal trajectory number form a trajectory; its first row is the release.
/// @throws InputError  if there is no such table, or times do not increase; names file and line
ObservedTrajectorySet read_trajectories(const std::filesystem::path& file);

/// Interpolates a trajectory linearly. After the last row, the state is constant.
/// @param time  since the release, s
TrajectoryPoint interpolate_trajectory(const ObservedTrajectory& trajectory, double time);

}  // namespace clast::study_detail
