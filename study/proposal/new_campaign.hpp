#pragma once
/// A campaign to begin with, proposed from a block library and a terrain.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "study/campaign/ground_types.hpp"
#include "terrain/terrain.hpp"

namespace clast {

/// Ends of a line in map coordinates, with the height of the ground, m.
struct ProposedLine {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

/// Where to release blocks and where to count them.
struct ProposedLines {
  /// Across the slope: in the upper part of the terrain, on steep ground.
  ProposedLine releases;
  std::size_t release_points = 1;  ///< evenly spaced on the line; of one, both ends are the same
  double release_slope = 0.0;      ///< of the ground there, rad
  double margin = 0.0;             ///< of the releases to the border, m
  /// "foot", or "halfway" where the trial runs moved it up.
  std::string barrier_name = "foot";
  /// Across the path, at the foot of the slope or, where it has none, before the ground ends;
  /// blocks cross it from left to right.
  ProposedLine barrier;
  double descent = 0.0;            ///< from the releases to the barrier, m
  double distance = 0.0;           ///< the same in the plan, m
  Vec2 downslope = Vec2::UnitX();  ///< of unit length, from the releases to the barrier
  std::vector<Vec3> path;     ///< of a sliding point mass from the middle of the releases; local, m
  double block_length = 0.0;  ///< L of the longest block, m
};

/// What some runs of a proposed campaign did.
struct TrialRuns {
  std::size_t count = 0;
  std::size_t passed = 0;        ///< the barrier at the foot of the slope
  double median_distance = 0.0;  ///< along `downslope` in the plan, m
  double longest = 0.0;          ///< duration of a run, s
};

/// What a zone is taken for.
struct ProposedGround {
  std::string zone;
  GroundType type;
  bool by_name = false;  ///< the zone's name says so; else it is a guess
};

/// The blocks that can be released on the terrain.
struct ProposedBlocks {
  std::vector<std::string> selected;  ///< empty: all of the library
  std::size_t count = 0;
  double longest_side = 0.0;   ///< L of the longest block, m
  double shortest_side = 0.0;  ///< S, median of the blocks, m
  std::optional<double> mass;  ///< kg, that all are brought to since they have no size of their own
  std::vector<std::string> left_out;  ///< "B03 has no size"
};

struct CampaignProposal {
  ProposedBlocks blocks;
  ProposedLines places;
  std::vector<ProposedGround> ground;  ///< of every zone of the terrain
  std::size_t orientations = 1;        ///< at each release point
  double max_time = 0.0;               ///< that runs have, s
  TrialRuns trial;
  std::vector<std::string> doubts;  ///< what its user must know, in words
};

/// @param surface       of the terrain
/// @param block_length  L of the longest block, m
/// @throws InputError  no ground is steep enough for blocks to start on, or all of it is too near
///                     to the border
ProposedLines propose_release_and_barrier(const Terrain& terrain, const TerrainSurface& surface,
                              double block_length);

/// Puts the barrier across the path, at most this far from the releases in the plan, m.
void place_barrier(const Terrain& terrain, const TerrainSurface& surface, double distance,
                   ProposedLines& places);

/// The campaign file: every value with a comment, to be read from top to bottom.
/// @param library, surface  paths as they are to stand in it
std::string campaign_text(const CampaignProposal& proposal, const std::string& library,
                          const std::vector<std::string>& surface);

/// Writes a campaign that `simulate` accepts: it is read, prepared and tried with a few runs before
/// it gets its name. Where hardly any of these pass the foot of the slope, the barrier is placed
/// where half of them have passed. Paths in it are relative to its folder.
/// @param surface  as in `TerrainOptions`; zones are those of a terrain file, else there is one
/// @param rules    whether it may replace a campaign; nothing else is ever replaced
/// @throws InputError  an input can't be read; the library holds no block that fits the terrain; or
///                     as `propose_release_and_barrier` or `OutputFile`
CampaignProposal write_new_campaign(const std::filesystem::path& library,
                                    const std::vector<std::filesystem::path>& surface,
                                    const std::filesystem::path& target,
                                    const OverwritePolicy& rules = {});

}  // namespace clast
