#pragma once
/// Blocks that were followed on their way down.
#include <filesystem>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace clast::study_detail {

/// A block at a time.
struct TrajectoryPoint {
  double time = 0.0;  ///< since its release, s
  Vec2 place = Vec2::Zero();
  double speed = 0.0;  ///< of the centre, m/s
  double spin = 0.0;   ///< rad/s
};

/// Rising in time, from the release.
using ObservedTrajectory = std::vector<TrajectoryPoint>;

struct ObservedTrajectorySet {
  std::string sha256;  ///< of the table
  std::vector<ObservedTrajectory> all;

  double longest() const;  ///< s
};

/// A table of numbers with the columns trajectory, time_s, x_m, y_m, speed_m_s and spin_rad_s; a
/// trajectory is the rows with its number, the first of which is its release.
/// @throws InputError  no such table, or times of a trajectory that do not rise: file and line
ObservedTrajectorySet read_trajectories(const std::filesystem::path& file);

/// Between the rows in a straight line; after the last row the last row.
/// @param time  since the release, s
TrajectoryPoint point_at(const ObservedTrajectory& trajectory, double time);

}  // namespace clast::study_detail
