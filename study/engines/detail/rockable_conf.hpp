#pragma once
/// Files that Rockable writes of a scene: snapshots ("conf12") and the track of a block.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dem/motion/rigid_body.hpp"

namespace clast::study_detail {

/// A body as a conf file has it. What Rockable could not compute is not a number.
struct ConfBody {
  std::string shape;
  std::uint32_t group = 0;
  double scale = 1.0;  ///< of lengths
  RigidState state;
};

/// What results need of a conf file.
struct RockableConf {
  double time = 0.0;      ///< s
  double max_time = 0.0;  ///< s
  double time_step = 0.0;
  std::size_t driven = 0;              ///< bodies that do not move, the first ones
  std::map<std::string, double> pair;  ///< "muContact 2 0", groups in either order
  std::vector<ConfBody> bodies;
};

/// @throws InputError  can't be read, or is no conf file: file, line, what was expected
RockableConf read_rockable_conf(const std::filesystem::path& file);

/// The snapshots of a folder in order of their numbers; none where the scene was not run.
std::vector<std::filesystem::path> list_rockable_states(const std::filesystem::path& folder);

/// What ends the run of a single block: TrackRockfall of dataExtractors.txt.
struct RockfallTracker {
  std::size_t body = 0;
  double rest_speed = 0.0;  ///< m/s, below which ...
  double rest_spin = 0.0;   ///< ... and below which, rad/s, the block is at rest
  std::string file;         ///< of the track
};
/// None where the folder has no dataExtractors.txt, or another extractor in it.
std::optional<RockfallTracker> read_rockfall_tracker(const std::filesystem::path& folder);

struct TrackedState {
  double time = 0.0;
  RigidState state;
};
/// The last whole line of a track; none where there is none.
std::optional<TrackedState> read_last_tracked_state(const std::filesystem::path& file);

}  // namespace clast::study_detail
