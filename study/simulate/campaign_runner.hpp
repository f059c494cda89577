#pragma once
/// Preparing, estimating and running a campaign.
#include <optional>
#include <vector>

#include "core/progress.hpp"
#include "library/block_library.hpp"
#include "study/campaign/campaign.hpp"
#include "study/campaign/planned_power.hpp"
#include "study/results/results.hpp"
#include "study/simulate/block_bodies.hpp"
#include "study/simulate/block_choice.hpp"
#include "study/simulate/process_team.hpp"

namespace clast {

/// Initial state of a multi-block release in one realisation.
struct MultiBlockStart {
  std::size_t blocks = 0;
  double volume = 0.0;  ///< solid volume of the blocks, m^3
  double mass = 0.0;    ///< kg
  double area = 0.0;    ///< of the polygon, m^2; this and the following members are for heaps only
  double mean_thickness = 0.0;     ///< height above the ground, averaged over the polygon, m
  double largest_thickness = 0.0;  ///< m

  /// Returns the solid fraction of the heap: block volume over the volume between ground and top.
  double solid_fraction() const { return volume / (area * mean_thickness); }
};

/// Campaign with loaded inputs and all decisions made: what would run, and how.
struct CampaignPlan {
  Campaign campaign;
  CampaignHeader header;
  CampaignBlocks choice;
  BlockBodies bodies;                     ///< bodies of `choice.blocks`
  std::optional<TerrainSurface> surface;  ///< surface of `header.terrain`; always set
  /// Planned runs, in order of blocks, release sets, points, orientations and ensemble members
  /// (fastest); persistent blocks: in order of realisations and releases.
  std::vector<RunRecord> runs;          ///< number of trial runs
  std::vector<MultiBlockStart> masses;  ///< multi-block releases of each realisation
};

/// Returns the dynamics settings of a run: those of the campaign, and the run's stiffness and time
/// step.
MotionSettings motion_settings(const Campaign& campaign, const RunRecord& run);
ReleaseSettings release_settings(const Campaign& campaign, const RunRecord& run);

/// Loads library and terrain, makes varied bodies, places all blocks and checks all starts.
/// @throws InputError  if inputs are inconsistent: a zone without parameters, parameters without a
///                     zone, no selected block, a point outside the terrain
/// @throws SimulationError  if a start is inside the ground; names block, point, orientation and
///                          depth
/// @throws GeometryError  if a body of [blocks] vary cannot be made
CampaignPlan prepare_campaign(const Campaign& campaign, const BlockPreparationOptions& making = {});

/// Samples the blocks again from `prepared.choice.library`, which stays complete, by the campaign's
/// present settings; runs are unchanged.
/// @throws InputError  as `sample_blocks`
void resample_blocks(CampaignPlan& prepared);

/// Shard: every n-th run (or realisation) of a campaign, for n independent jobs whose results
/// `merge_results` joins.
struct Shard {
  std::uint32_t index = 1;  ///< from 1
  std::uint32_t count = 1;

  /// Returns true if the shard contains a run or realisation.
  /// @param item  index of the run or realisation
  bool has(std::uint32_t item) const { return item % count == index - 1; }
  /// Returns the number of runs in the shard.
  std::size_t runs_of(const CampaignPlan& prepared) const;
  void check() const;  ///< throws InputError naming both
};

/// Duration of runs, measured on a sample of them.
struct TimeProbe {
  std::size_t runs = 0;    ///< that were tried
  double each = 0.0;       ///< mean duration of a run on one thread, s
  bool cut_short = false;  ///< the last trial run was stopped early
  /// Message of the first failed trial run; empty if none failed.
  std::string failure = {};
  /// True if the stopped run was extrapolated to its time limit, so that `each` is an upper bound.
  bool at_most = false;
  /// Runouts of the completed trial runs, m: along `downslope` if given, otherwise horizontal
  /// distances.
  std::vector<double> runouts = {};
};
/// Runs a sample of the campaign one by one until `budget` seconds are spent, or one run has taken
/// several times that; at least one run. Results are discarded.
/// @throws InputError  if more memory is needed than is free
TimeProbe probe_time(const CampaignPlan& prepared, double budget);
/// Computes the planned power from the trial runs; empty for persistent blocks.
PlannedPower planned_power(const CampaignPlan& prepared, const TimeProbe& probe);
/// Estimates the duration of a shard on a number of threads, s.
double estimate_time(const CampaignPlan& prepared, const TimeProbe& probe, const Shard& shard,
                     unsigned threads);

struct RunOptions {
  unsigned threads = 0;  ///< 0: one per core
  /// If true, an interrupted campaign is resumed, or started if there is none; if false, its runs
  /// are discarded.
  bool resume = false;
  /// If true, finished results in the target are replaced; otherwise they are an error. Resuming a
  /// finished campaign does nothing.
  bool replace = false;
  Shard shard = {};
  /// Processes that share the runs; only the leader writes. Null: this process alone.
  ProcessTeam* team = nullptr;
  /// Called after each run with the numbers of finished and planned runs, and during long
  /// realisations; from any thread, one call at a time.
  ProgressCallback progress = {};
  /// Wall-clock interval between checkpoints of a realisation of persistent blocks, s, or 20 times
  /// the writing time if that is longer; 0: only when `progress` ends the campaign.
  double checkpoint_interval = 300.0;
};

/// Runs all runs that are not stored yet and writes `target`. Failed runs are stored with stop
/// reason `error` and their message. The datasets do not depend on the number of threads or
/// processes or on interruptions. If `progress` throws, the current runs are finished and kept, and
/// checkpoints of current realisations are written, from which `resume` continues. In a team only
/// the leader calls `progress`; checkpoints of the others need a shared file system.
/// @throws InputError  if the target cannot be written or holds results that are kept; if the
///                     journal belongs to another campaign or shard; if a checkpoint is damaged; or
///                     if more memory is needed than is free
void run_campaign(const CampaignPlan& prepared, const std::filesystem::path& target,
                  const RunOptions& options = {});

}  // namespace clast
