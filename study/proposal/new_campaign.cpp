#include "study/proposal/new_campaign.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/files/file_kind.hpp"
#include "core/number_text.hpp"
#include "core/statistics/statistics.hpp"
#include "library/block_ranges.hpp"
#include "library/unscaled.hpp"
#include "study/proposal/detail/trial_runs.hpp"
#include "study/simulate/campaign_checks.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {

using namespace study_detail;
namespace {

namespace fs = std::filesystem;

constexpr double kUsualMass = 1000.0;  ///< kg, of blocks without a size
constexpr double kSmallShare = 0.05;   ///< of the terrain, that such a block is long at most
constexpr std::size_t kFewRuns = 400;  ///< to see something within minutes
constexpr std::size_t kMostOrientations = 16;
/// No more time is proposed for a run, s.
constexpr double kLongestTime = 480.0;
/// Blocks over edges and overhangs can still be in the ground at the first of these, m.
constexpr std::array<double, 4> kDropHeights = {1.0, 2.0, 5.0, 10.0};

/// Why a block can't be released on a terrain of this extent; empty: it can.
std::string misfit(const Block& block, double extent) {
  if (is_unscaled(block)) return block.id + " has no size";
  const double length = block.axes().L;
  if (length > std::min(kLongestUsual, kLargestShare * extent)) {
    return block.id + " is " + with_digits(length, 3) + " m long, on a terrain of " +
           with_digits(extent, 3) + " m";
  }
  if (block.mass.mass > kHeaviestUsual) {
    return block.id + " is " + with_digits(block.mass.mass / 1000.0, 3) + " t heavy";
  }
  return "";
}

/// All blocks at one mass, since none has a size.
ProposedBlocks sized_blocks(const BlockLibrary& library, double extent, double& longest) {
  ProposedBlocks blocks;
  blocks.count = library.blocks().size();
  double most = kUsualMass;
  for (const Block& block : library.blocks()) {
    const double length_of_unit_mass = block.axes().L / std::cbrt(block.mass.mass);
    most = std::min(most, std::pow(kSmallShare * extent / length_of_unit_mass, 3.0));
  }
  // Two digits, rounded down.
  const double digit = std::pow(10.0, std::floor(std::log10(most)) - 1.0);
  blocks.mass = digit * std::floor(most / digit * (1.0 + 1e-12));
  for (const Block& block : library.blocks()) {
    longest = std::max(longest, block.axes().L * std::cbrt(*blocks.mass / block.mass.mass));
  }
  blocks.lightest = blocks.heaviest = *blocks.mass;
  std::vector<double> sides;
  for (const Block& block : library.blocks()) {
    sides.push_back(block.axes().S * std::cbrt(*blocks.mass / block.mass.mass));
  }
  blocks.shortest_side = summarise(sides).median;
  return blocks;
}

/// @param longest  becomes L of the longest block, m
ProposedBlocks propose_blocks(const BlockLibrary& library, double extent, double& longest) {
  if (library.blocks().empty()) {
    throw InputError("the library holds no block; add some with clast reconstruct");
  }
  const auto unscaled = [](const Block& block) { return is_unscaled(block); };
  if (std::all_of(library.blocks().begin(), library.blocks().end(), unscaled)) {
    return sized_blocks(library, extent, longest);
  }
  ProposedBlocks blocks;
  std::vector<double> sides;
  for (const Block& block : library.blocks()) {
    const std::string why = misfit(block, extent);
    if (!why.empty()) {
      blocks.left_out.push_back(why);
      continue;
    }
    blocks.selected.push_back(block.id);
    blocks.lightest =
        blocks.selected.size() == 1 ? block.mass.mass : std::min(blocks.lightest, block.mass.mass);
    blocks.heaviest = std::max(blocks.heaviest, block.mass.mass);
    longest = std::max(longest, block.axes().L);
    sides.push_back(block.axes().S);
  }
  blocks.count = blocks.selected.size();
  if (!sides.empty()) blocks.shortest_side = summarise(sides).median;
  if (blocks.selected.empty()) {
    throw InputError("no block of the library fits the terrain: " + blocks.left_out.front() +
                     "; check the units of scans and terrain");
  }
  if (blocks.left_out.empty()) blocks.selected.clear();
  return blocks;
}

std::vector<ProposedGround> propose_ground(const std::vector<std::string>& zones) {
  std::vector<ProposedGround> ground;
  for (const std::string& zone : zones) {
    const GroundType* type = ground_type_of_zone(zone);
    ground.push_back({zone, type ? *type : default_ground_type(), type != nullptr});
  }
  return ground;
}

std::vector<std::string> doubts_of(const CampaignProposal& proposal) {
  std::vector<std::string> doubts;
  const double slope = proposal.places.release_slope * kDegreesPerRadian;
  if (slope < 25.0) {
    doubts.push_back("the steepest ground is " + with_decimals(slope, 0) +
                     " degrees, on which many blocks stop where they land");
  }
  std::size_t guessed = 0;
  for (const ProposedGround& zone : proposal.ground) guessed += zone.by_name ? 0 : 1;
  if (guessed > 0) {
    doubts.push_back(counted(guessed, "ground zone") + (guessed == 1 ? " is" : " are") +
                     " taken for " + default_ground_type().name +
                     ", since the name says no kind of ground");
  }
  if (proposal.blocks.mass) {
    doubts.push_back("the blocks have no size of their own; " +
                     with_digits(*proposal.blocks.mass, 6) + " kg each is an assumption");
  }
  if (!proposal.blocks.left_out.empty()) {
    doubts.push_back(counted(proposal.blocks.left_out.size(), "block") + " of the library " +
                     (proposal.blocks.left_out.size() == 1 ? "is" : "are") +
                     " left out: " + proposal.blocks.left_out.front() +
                     (proposal.blocks.left_out.size() > 1 ? ", ..." : ""));
  }
  return doubts;
}

/// As it is written in a campaign of this folder.
std::string relative_path(const fs::path& path, const fs::path& folder) {
  return fs::weakly_canonical(fs::absolute(path)).lexically_proximate(folder).string();
}

CampaignProposal proposal_from(const fs::path& library, const std::vector<fs::path>& surface) {
  TerrainOptions terrain;
  terrain.surface = surface;
  const BlockLibrary blocks = BlockLibrary::read(library);
  const Terrain ground = read_terrain(terrain);
  try {
    return propose_campaign(blocks, ground);
  } catch (const InputError& error) {
    throw InputError(library.string() + " on " + surface.front().string() + ": " + error.what());
  }
}

}  // namespace

CampaignProposal propose_campaign(const BlockLibrary& library, const Terrain& terrain) {
  CampaignProposal proposal;
  const Bounds box = bounds(terrain.surface);
  double longest = 0.0;
  proposal.blocks = propose_blocks(library, (box.high - box.low).head<2>().maxCoeff(), longest);
  proposal.places = propose_places(terrain, longest);
  proposal.ground = propose_ground(terrain.zone_names);
  proposal.orientations = std::clamp<std::size_t>(
      kFewRuns / (proposal.blocks.count * proposal.places.release_points), 1, kMostOrientations);
  proposal.drop_height = kDropHeights.front();
  proposal.doubts = doubts_of(proposal);
  return proposal;
}

/// Reads and prepares the campaign with the lowest height of release at which no block starts in
/// the ground.
PreparedCampaign prepare_proposal(OutputFile& output, CampaignProposal& proposal,
                                  const std::string& library,
                                  const std::vector<std::string>& surface) {
  for (const double height : kDropHeights) {
    proposal.drop_height = height;
    output.write(campaign_text(proposal, library, surface));
    try {
      return prepare_campaign(read_campaign(output.temporary()));
    } catch (const SimulationError&) {  // a start in the ground
      if (height == kDropHeights.back()) throw;
    }
  }
  throw SimulationError("no height of release was tried");
}

CampaignProposal write_new_campaign(const fs::path& library, const std::vector<fs::path>& surface,
                                    const fs::path& target, const OutputRules& rules) {
  OutputRules campaigns_only = rules;
  campaigns_only.kind = kCampaignKind;
  OutputFile output(target, campaigns_only);
  CampaignProposal proposal = proposal_from(library, surface);
  const fs::path folder = fs::weakly_canonical(fs::absolute(output.target())).parent_path();
  std::vector<std::string> surface_paths;
  for (const fs::path& path : surface) surface_paths.push_back(relative_path(path, folder));
  const std::string blocks = relative_path(library, folder);
  std::optional<PreparedCampaign> prepared;
  do {
    if (prepared) proposal.max_time *= 2.0;
    prepared.emplace(prepare_proposal(output, proposal, blocks, surface_paths));
    run_trials(*prepared, proposal);
  } while (2.0 * proposal.trial.longest > proposal.max_time && proposal.max_time < kLongestTime);
  judge_trials(*prepared, proposal);
  output.write(campaign_text(proposal, blocks, surface_paths));
  output.commit();
  return proposal;
}

}  // namespace clast
