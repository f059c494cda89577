#pragma once
/// Proposal of a campaign for a block library and a terrain.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "study/campaign/ground_types.hpp"
#include "terrain/terrain.hpp"

namespace clast {

/// Line in map coordinates, with ground heights, m.
struct ProposedLine {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

struct ProposedLines {
  /// Release line across the slope, on steep ground in the upper part of the terrain.
  ProposedLine releases;
  std::size_t release_points = 1;  ///< equally spaced; for one point, both line ends coincide
  double release_slope = 0.0;      ///< slope of the ground at the line, rad
  double margin = 0.0;             ///< distance of the releases to the border, m
  /// Name of the barrier: "foot", or "halfway" if the trial runs moved it up.
  std::string barrier_name = "foot";
  /// Barrier across the path at the foot of the slope, or before the end of the ground; blocks
  /// cross it from left to right.
  ProposedLine barrier;
  double descent = 0.0;            ///< height difference between releases and barrier, m
  double distance = 0.0;           ///< horizontal distance between releases and barrier, m
  Vec2 downslope = Vec2::UnitX();  ///< unit vector from the releases to the barrier
  std::vector<Vec3>
      path;  ///< path of a sliding point mass from the midpoint of the releases; local frame, m
  double block_length = 0.0;  ///< L of the longest block, m
};

struct TrialRuns {
  std::size_t count = 0;
  std::size_t passed = 0;        ///< number of runs that passed the barrier at the foot
  double median_distance = 0.0;  ///< horizontal, along `downslope`, m
  double longest = 0.0;          ///< longest duration, s
};

/// Ground type assumed for a zone.
struct ProposedGround {
  std::string zone;
  GroundType type;
  bool by_name = false;  ///< true if the zone name identifies the type; false: a guess
};

/// Blocks that can be released on the terrain.
struct ProposedBlocks {
  std::vector<std::string> selected;  ///< empty: all of the library
  std::size_t count = 0;
  double longest_side = 0.0;          ///< L of the longest block, m
  double shortest_side = 0.0;         ///< median S of the blocks, m
  std::optional<double> mass;         ///< mass given to all blocks because they have no scale, kg
  std::vector<std::string> left_out;  ///< reasons, such as "B03 has no size"
};

struct CampaignProposal {
  ProposedBlocks blocks;
  ProposedLines places;
  std::vector<ProposedGround> ground;  ///< one per zone of the terrain
  std::size_t orientations = 1;        ///< per release point
  double max_time = 0.0;               ///< time limit of runs, s
  TrialRuns trial;
  std::vector<std::string> doubts;  ///< warnings for the user
};

/// Proposes a release line and a barrier.
/// @param surface  of the terrain
/// @param block_length  L of the longest block, m
/// @throws InputError  if no ground is steep enough to start blocks, or all of it is too near to
///                     the border
ProposedLines propose_release_and_barrier(const Terrain& terrain, const TerrainSurface& surface,
                                          double block_length);

/// Places the barrier across the path at a horizontal distance (m) from the releases, or nearer.
void place_barrier(const Terrain& terrain, const TerrainSurface& surface, double distance,
                   ProposedLines& places);

/// Formats the campaign file, with a comment for each value.
/// @param library, surface  paths as written in the file
std::string format_campaign_text(const CampaignProposal& proposal, const std::string& library,
                                 const std::vector<std::string>& surface);

/// Writes a campaign that `simulate` accepts: it is read, prepared and tried with a few runs before
/// it is renamed. If hardly any trial run passes the foot, the barrier is placed where half of them
/// pass. Paths are relative to the file's folder.
/// @param surface  as in `TerrainOptions`; zones are read from a terrain file, otherwise there is
///                 one zone
/// @param rules  whether an existing campaign is replaced; other files never are
/// @throws InputError  if an input cannot be read or no block fits the terrain; or as
///                     `propose_release_and_barrier` or `OutputFile`
CampaignProposal write_new_campaign(const std::filesystem::path& library,
                                    const std::vector<std::filesystem::path>& surface,
                                    const std::filesystem::path& target,
                                    const OverwritePolicy& rules = {});

}  // namespace clast
