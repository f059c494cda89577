#pragma once
/// A campaign to begin with, proposed from a block library and a terrain.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/output_file.hpp"
#include "library/block_library.hpp"
#include "study/campaign/ground_types.hpp"
#include "terrain/terrain.hpp"

namespace clast {

/// A place of the plan in map coordinates, and the height of the ground there, m.
using MapPoint = Vec3;

/// Where to release blocks and where to count them.
struct ProposedPlaces {
  /// Ends of a line across the slope: in the upper part of the terrain, on steep ground, with
  /// `margin` to its border.
  MapPoint release_from = MapPoint::Zero(), release_to = MapPoint::Zero();
  std::size_t release_points = 1;  ///< evenly spaced on the line; of one, both ends are the same
  double release_slope = 0.0;      ///< of the ground there, rad
  double margin = 0.0;             ///< m
  /// Ends of a line across the way down, at the foot of the slope or, where it has none, before
  /// the ground ends; blocks cross it from left to right.
  std::string barrier_name = "foot";
  MapPoint barrier_from = MapPoint::Zero(), barrier_to = MapPoint::Zero();
  double descent = 0.0;            ///< from the releases to the barrier, m
  double distance = 0.0;           ///< the same in the plan, m
  Vec2 downslope = Vec2::UnitX();  ///< of unit length, from the releases to the barrier
  /// From the middle of the releases, as a point mass would slide; local frame, m.
  std::vector<Vec3> way_down;
  double block_length = 0.0;  ///< L of the longest block, m
};

/// What some runs of a proposed campaign did.
struct TrialRuns {
  std::size_t count = 0;
  std::size_t passed = 0;  ///< the barrier at the foot of the slope
  /// That half of them go along `downslope` in the plan, m.
  double median_distance = 0.0;
  bool moved_barrier = false;  ///< to that distance, since hardly any passed it at the foot
  double longest = 0.0;        ///< run, s
  std::size_t moving = 0;      ///< still, when their time was up
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
  double lightest = 0.0, heaviest = 0.0;  ///< kg
  double shortest_side = 0.0;             ///< S, median of the blocks, m
  std::optional<double> mass;  ///< kg, that all are brought to since they have no size of their own
  std::vector<std::string> left_out;  ///< "B03 has no size"
};

struct CampaignProposal {
  ProposedBlocks blocks;
  ProposedPlaces places;
  std::vector<ProposedGround> ground;  ///< of every zone of the terrain
  std::size_t orientations = 1;        ///< at each release point
  double drop_height = 1.0;            ///< of the lowest skin point above the ground, m
  double max_time = 60.0;              ///< that runs have, s; trial runs take half of it at most
  TrialRuns trial;
  std::vector<std::string> doubts;  ///< what its user must know, in words
};

/// @param block_length  L of the longest block, m
/// @throws InputError  no ground is steep enough for blocks to start on, or all of it is too near
///                     to the border
ProposedPlaces propose_places(const Terrain& terrain, double block_length);

/// Puts the barrier across the way down, at most this far from the releases in the plan, m.
void place_barrier(const Terrain& terrain, double distance, ProposedPlaces& places);

/// @throws InputError  as `propose_places`; or the library holds no block that fits the terrain
CampaignProposal propose_campaign(const BlockLibrary& library, const Terrain& terrain);

/// The campaign file: every value with a comment, to be read from top to bottom.
/// @param library, surface  paths as they are to stand in it
std::string campaign_text(const CampaignProposal& proposal, const std::string& library,
                          const std::vector<std::string>& surface);

/// Writes a campaign that `simulate` accepts: it is read, prepared and tried with a few runs before
/// it gets its name. Where these stop above the foot of the slope, the barrier is placed where half
/// of them have passed.
/// Paths in it are relative to its folder.
/// @param surface  as in `TerrainOptions`; zones are those of a terrain file, else there is one
/// @param rules    whether it may replace a campaign; nothing else is ever replaced
/// @throws InputError  an input can't be read, or as `propose_campaign` or `OutputFile`
CampaignProposal write_new_campaign(const std::filesystem::path& library,
                                    const std::vector<std::filesystem::path>& surface,
                                    const std::filesystem::path& target,
                                    const OutputRules& rules = {});

}  // namespace clast
