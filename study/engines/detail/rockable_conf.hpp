#pragma once
/// Reading of Rockable's output: snapshots (conf files) and block tracks.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dem/motion/rigid_body.hpp"

namespace clast::study_detail {

/// Body of a conf file of Rockable. Values that Rockable could not compute are NaN.
struct RockableBody {
  std::string shape;
  std::uint32_t group = 0;
  double scale = 1.0;  ///< scale of lengths
  RigidState state;
};

/// Contents of a conf file of Rockable that are needed to import results.
struct RockableConf {
  double time = 0.0;      ///< s
  double max_time = 0.0;  ///< s
  double time_step = 0.0;
  std::size_t fixed_body_count = 0;  ///< number of fixed bodies, the first ones
  /// Contact parameters of pairs of groups, by name, such as "muContact 2 0".
  std::map<std::string, double> pair;
  std::vector<RockableBody> bodies;
};

/// Reads a conf file of Rockable.
/// @throws InputError  if the file cannot be read or is not a conf file; names file, line and
///                     expectation
RockableConf read_rockable_conf(const std::filesystem::path& file);

/// Lists the conf files that Rockable wrote to a folder, in order of time. Empty if the scene was
/// not run.
std::vector<std::filesystem::path> list_rockable_states(const std::filesystem::path& folder);

/// Stop criterion of a single block in Rockable (TrackRockfall in dataExtractors.txt).
struct RockfallTracker {
  std::size_t body = 0;
  double rest_speed = 0.0;  ///< maximum speed at rest, m/s
  double rest_spin = 0.0;   ///< maximum angular speed at rest, rad/s
  std::string file;         ///< name of the track file
};
/// Reads the stop criterion of a scene folder. Empty if there is none.
std::optional<RockfallTracker> read_rockfall_tracker(const std::filesystem::path& folder);

struct TrackedState {
  double time = 0.0;
  RigidState state;
};
/// Reads the last complete line of a track file of Rockable. Empty if there is none.
std::optional<TrackedState> read_last_tracked_state(const std::filesystem::path& file);

}  // namespace clast::study_detail
