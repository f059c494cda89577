#include "study/proposal/new_campaign.hpp"

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/files/file_kind.hpp"
#include "core/number_text.hpp"
#include "core/parallel.hpp"
#include "core/statistics/statistics.hpp"
#include "library/block_library.hpp"
#include "library/unscaled.hpp"
#include "study/simulate/campaign_checks.hpp"
#include "study/simulate/campaign_runner.hpp"
#include "study/simulate/realisation.hpp"
#include "terrain/terrain_input.hpp"

namespace clast {

using namespace study_detail;
namespace {

namespace fs = std::filesystem;

constexpr double kUsualMass = 1000.0;    ///< kg, of blocks without a size
constexpr double kSmallFraction = 0.05;  ///< of the terrain, that such a block is long at most
constexpr std::size_t kFewRuns = 400;    ///< to see something within minutes
constexpr std::size_t kMaxOrientations = 16;
constexpr double kLongestTime = 480.0;  ///< that runs have, s; trial runs have all of it
constexpr std::size_t kTrialRuns = 16;  ///< enough to see what half of them do, within seconds
constexpr double kFewPass = 0.25;       ///< of them: a barrier there says little
constexpr double kMinDistance = 2.0;    ///< L that blocks go at least, for a barrier to make sense

/// The mass of all blocks where none has a size, at which each is short on the terrain, kg.
double assumed_mass(const std::vector<Block>& blocks, double extent) {
  double maximum = kUsualMass;
  for (const Block& block : blocks) {
    maximum = std::min(maximum,
                       block.mass.mass * std::pow(kSmallFraction * extent / block.axes().L, 3.0));
  }
  // Two digits, rounded down.
  const double digit = std::pow(10.0, std::floor(std::log10(maximum)) - 1.0);
  return digit * std::floor(maximum / digit * (1.0 + 1e-12));
}

ProposedBlocks propose_blocks(const BlockLibrary& library, double extent) {
  const std::vector<Block>& all = library.blocks();
  if (all.empty()) {
    throw InputError("the library holds no block; add some with clast reconstruct");
  }
  ProposedBlocks blocks;
  if (std::all_of(all.begin(), all.end(), [](const Block& block) { return is_unscaled(block); })) {
    blocks.mass = assumed_mass(all, extent);
  }
  std::vector<double> sides;
  for (const Block& block : all) {
    const std::string why = blocks.mass          ? ""
                            : is_unscaled(block) ? block.id + " has no size"
                                                 : describe_unusual_size(block.id, block.axes().L,
                                                                         block.mass.mass, extent);
    if (!why.empty()) {
      blocks.omitted_blocks.push_back(why);
      continue;
    }
    const double scale = blocks.mass ? std::cbrt(*blocks.mass / block.mass.mass) : 1.0;
    blocks.selected.push_back(block.id);
    blocks.longest_side = std::max(blocks.longest_side, scale * block.axes().L);
    sides.push_back(scale * block.axes().S);
  }
  if (sides.empty()) {
    throw InputError("no block of the library fits the terrain: " + blocks.omitted_blocks.front() +
                     "; check the units of scans and terrain");
  }
  blocks.count = sides.size();
  blocks.shortest_side = summarise_sample(sides).median;
  if (blocks.omitted_blocks.empty()) blocks.selected.clear();
  return blocks;
}

CampaignProposal propose_campaign(const BlockLibrary& library, const Terrain& terrain) {
  CampaignProposal proposal;
  const Bounds box = bounds(terrain.surface);
  proposal.blocks = propose_blocks(library, (box.high - box.low).head<2>().maxCoeff());
  proposal.places = propose_release_and_barrier(terrain, make_terrain_surface(terrain),
                                                proposal.blocks.longest_side);
  for (const std::string& zone : terrain.zone_names) {
    const GroundType* type = find_ground_type(zone);
    proposal.ground.push_back({zone, type ? *type : default_ground_type(), type != nullptr});
  }
  proposal.orientations = std::clamp<std::size_t>(
      kFewRuns / (proposal.blocks.count * proposal.places.release_points), 1, kMaxOrientations);
  return proposal;
}

/// Runs a few releases of the campaign. Where hardly any of them passes the barrier, its only one,
/// that is placed where half of them have passed.
void try_runs(const CampaignPlan& prepared, CampaignProposal& proposal) {
  TrialRuns& trial = proposal.trial;
  ProposedReleaseAndBarrier& places = proposal.places;
  trial.count = std::min(kTrialRuns, prepared.runs.size());
  std::vector<StoredRun> runs(trial.count);
  parallel_for(trial.count, 0, [&](std::size_t i) {
    const std::size_t run = i * prepared.runs.size() / trial.count;
    runs[i] = simulate_realisation(prepared, static_cast<std::uint32_t>(run)).front();
  });
  std::vector<double> distances;
  for (const StoredRun& run : runs) {
    const ReleaseResult& result = run.record.result;
    const Vec3 way = result.final_state.position - run.record.start.position;
    distances.push_back(way.head<2>().dot(places.downslope));
    trial.passed += run.crossings.empty() ? 0 : 1;
    trial.longest = std::max(trial.longest, result.duration);
  }
  trial.median_distance = summarise_sample(distances).median;
  // Full minutes.
  proposal.max_time = std::min(60.0 * std::ceil(2.0 * trial.longest / 60.0), kLongestTime);
  if (static_cast<double>(trial.passed) >= kFewPass * static_cast<double>(trial.count)) return;
  std::string doubt = std::to_string(trial.passed) + " of " +
                      format_count(trial.count, "trial run") +
                      " passed the foot of the slope, and half of them travelled less than " +
                      format_decimals(std::max(trial.median_distance, 0.0), 1) + " m";
  if (trial.median_distance > kMinDistance * places.block_length &&
      trial.median_distance < places.distance) {
    place_barrier(prepared.header.terrain, *prepared.surface, trial.median_distance, places);
    places.barrier_name = "halfway";
    doubt +=
        "; the barrier lies there, " + format_decimals(places.distance, 0) + " m from the releases";
  }
  proposal.proposal_warnings.push_back(doubt);
}

/// Lists the assumptions as text.
std::vector<std::string> assumptions(const CampaignProposal& proposal) {
  std::vector<std::string> proposal_warnings;
  const double slope = proposal.places.release_slope * kDegreesPerRadian;
  if (slope < 25.0) {
    proposal_warnings.push_back("the steepest ground is " + format_decimals(slope, 0) +
                                " degrees, on which many blocks stop where they land");
  }
  const auto guessed = static_cast<std::size_t>(
      std::count_if(proposal.ground.begin(), proposal.ground.end(),
                    [](const ProposedGround& zone) { return !zone.identified_by_name; }));
  if (guessed > 0) {
    proposal_warnings.push_back(format_count(guessed, "ground zone is", "ground zones are") +
                                " taken for " + default_ground_type().name +
                                ", since the name gives no ground type");
  }
  if (proposal.blocks.mass) {
    proposal_warnings.push_back("the blocks have no known size; " +
                                format_significant(*proposal.blocks.mass, 6) +
                                " kg each is an assumption");
  }
  if (const std::vector<std::string>& out = proposal.blocks.omitted_blocks; !out.empty()) {
    proposal_warnings.push_back(
        format_count(out.size(), "block of the library is", "blocks of the library are") +
        " left out: " + out.front() +
        (out.size() > 1 ? ", and " + std::to_string(out.size() - 1) + " more" : ""));
  }
  return proposal_warnings;
}

/// Path as written in a campaign of this folder.
std::string relative_path(const fs::path& path, const fs::path& folder) {
  return fs::weakly_canonical(fs::absolute(path)).lexically_proximate(folder).string();
}

}  // namespace

CampaignProposal write_new_campaign(const fs::path& library, const std::vector<fs::path>& surface,
                                    const fs::path& target, const OverwritePolicy& rules) {
  OverwritePolicy campaigns_only = rules;
  campaigns_only.kind = kCampaignKind;
  OutputFile output(target, campaigns_only);
  const BlockLibrary blocks = BlockLibrary::read(library);
  TerrainOptions options;
  options.surface = surface;
  const Terrain terrain = read_terrain(options);
  CampaignProposal proposal;
  try {
    proposal = propose_campaign(blocks, terrain);
  } catch (const InputError& error) {
    throw InputError(library.string() + " on " + surface.front().string() + ": " + error.what());
  }
  const fs::path folder = fs::weakly_canonical(fs::absolute(output.target_path())).parent_path();
  std::vector<std::string> surface_paths;
  for (const fs::path& path : surface) surface_paths.push_back(relative_path(path, folder));
  const std::string library_path = relative_path(library, folder);
  proposal.max_time = kLongestTime;
  proposal.proposal_warnings = assumptions(proposal);
  output.write(format_campaign_text(proposal, library_path, surface_paths));
  try_runs(prepare_campaign(read_campaign(output.temporary_path())), proposal);
  output.write(format_campaign_text(proposal, library_path, surface_paths));
  output.commit();
  return proposal;
}

}  // namespace clast
