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

/// Proposed release line or barrier: end points on the ground in map coordinates, m.
struct ProposedLine {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

struct ProposedReleaseAndBarrier {
  /// Line of release points across the slope, on steep ground in the upper part of the terrain.
  ProposedLine releases;
  std::size_t release_points = 1;  ///< number of equally spaced release points
  double release_slope = 0.0;      ///< slope of the ground at the line, rad
  double margin = 0.0;             ///< distance of the release line from the terrain border, m
  /// Name of the barrier: "foot", or "halfway" if few trial runs reached the foot of the slope.
  std::string barrier_name = "foot";
  /// Barrier across the path at the foot of the slope. Blocks cross it from left to right.
  ProposedLine barrier;
  double descent = 0.0;            ///< height difference between releases and barrier, m
  double distance = 0.0;           ///< horizontal distance between releases and barrier, m
  Vec2 downslope = Vec2::UnitX();  ///< unit vector from the releases to the barrier
  std::vector<Vec3> path;     ///< path of a sliding point mass from the releases, local frame, m
  double block_length = 0.0;  ///< L of the longest block, m
};

struct TrialRuns {
  std::size_t count = 0;
  std::size_t passed = 0;        ///< number of runs that passed the barrier at the foot
  double median_distance = 0.0;  ///< median horizontal distance along `downslope`, m
  double longest = 0.0;          ///< longest simulated duration of a run, s
};

/// Ground type assumed for a zone.
struct ProposedGround {
  std::string zone;
  GroundType type;
  /// True if the zone name identifies the type; false if it is a default.
  bool identified_by_name = false;
};

/// Blocks that can be released on the terrain.
struct ProposedBlocks {
  /// Ids of the blocks; empty if all blocks of the library are used.
  std::vector<std::string> selected;
  std::size_t count = 0;
  double longest_side = 0.0;   ///< L of the longest block, m
  double shortest_side = 0.0;  ///< median of the shortest sides of the blocks, m
  std::optional<double> mass;  ///< mass assumed for all blocks if they have no scale, kg
  /// Omitted blocks with reasons, such as "B03 has no size".
  std::vector<std::string> omitted_blocks;
};

struct CampaignProposal {
  ProposedBlocks blocks;
  ProposedReleaseAndBarrier places;
  std::vector<ProposedGround> ground;  ///< one per zone of the terrain
  std::size_t orientations = 1;        ///< number of orientations per release point
  double max_time = 0.0;               ///< time limit of runs, s
  TrialRuns trial;
  std::vector<std::string> proposal_warnings;  ///< warnings about the proposal
};

/// Proposes a release line and a barrier.
/// @param surface  surface of `terrain`
/// @param block_length  L of the longest block, m
/// @throws InputError  if no ground is steep enough to start blocks, or if all steep ground is too
///                     near to the border
ProposedReleaseAndBarrier propose_release_and_barrier(const Terrain& terrain,
                                                      const TerrainSurface& surface,
                                                      double block_length);

/// Places the barrier of a proposal across the path, at the horizontal distance `distance` (m) from
/// the releases or at the end of the path.
void place_barrier(const Terrain& terrain, const TerrainSurface& surface, double distance,
                   ProposedReleaseAndBarrier& places);

/// Formats a proposed campaign as text of a campaign file, with a comment for each value.
/// @param library, surface  paths as written in the file
std::string format_campaign_text(const CampaignProposal& proposal, const std::string& library,
                                 const std::vector<std::string>& surface);

/// Proposes a campaign, tries it with a few runs and writes its file. If hardly any trial run
/// passes the foot of the slope, the barrier is placed where half of them pass.
/// @param surface  files as in `TerrainOptions`; zones are read if it is a terrain file, otherwise
///                 there is one zone
/// @param rules  policy for existing campaigns; other files are never replaced
/// @throws InputError  if an input cannot be read, no block fits the terrain, the file cannot be
///                     written, or `propose_release_and_barrier` throws
CampaignProposal write_new_campaign(const std::filesystem::path& library,
                                    const std::vector<std::filesystem::path>& surface,
                                    const std::filesystem::path& target,
                                    const OverwritePolicy& rules = {});

}  // namespace clast
