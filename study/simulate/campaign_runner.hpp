#pragma once
/// Preparation, time estimate and execution of a campaign.
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
  double area =
      0.0;  ///< area of the polygon, m^2; this and the following members are set for heaps only
  double mean_thickness = 0.0;     ///< mean height above the ground over the polygon, m
  double largest_thickness = 0.0;  ///< largest height above the ground, m

  /// Solid fraction of the heap: volume of the blocks over the volume between ground and top.
  double solid_fraction() const { return volume / (area * mean_thickness); }
};

/// Prepared campaign: loaded inputs, planned runs and all settings.
struct CampaignPlan {
  Campaign campaign;
  CampaignHeader header;
  CampaignBlocks choice;
  BlockBodies bodies;  ///< bodies of `choice.blocks`
  std::optional<TerrainSurface>
      surface;  ///< surface of `header.terrain`; set by `prepare_campaign`
  /// Planned runs, ordered by block, release set, point, orientation and ensemble member. Runs of
  /// persistent blocks are ordered by realisation, then by release.
  std::vector<RunRecord> runs;
  std::vector<MultiBlockStart> masses;  ///< multi-block releases of each realisation
};

/// Returns the settings of the campaign with stiffness and time step of a run.
MotionSettings motion_settings(const Campaign& campaign, const RunRecord& run);
ReleaseSettings release_settings(const Campaign& campaign, const RunRecord& run);

/// Prepares a campaign: loads library and terrain, varies and places blocks, and checks all starts.
/// @throws InputError  if inputs are inconsistent, for example if a zone has no parameters or a
///                     point is outside the terrain
/// @throws SimulationError  if a start is in the ground; names block, point, orientation and depth
/// @throws GeometryError  if a body of `vary` in [blocks] cannot be made
CampaignPlan prepare_campaign(const Campaign& campaign,
                              const BlockPreparationOptions& preparation = {});

/// Samples the blocks again from `prepared.choice.library` with the present settings of the
/// campaign. The library and the runs are unchanged.
/// @throws InputError  if `sample_blocks` throws
void resample_blocks(CampaignPlan& prepared);

/// Shard: every n-th run or realisation, for n independent jobs. `merge_results` joins the results.
struct Shard {
  std::uint32_t index = 1;  ///< number of this shard, from 1 to `count`
  std::uint32_t count = 1;

  /// Returns true if the shard contains a run or realisation.
  /// @param item  index of the run or realisation
  bool contains(std::uint32_t item) const { return item % count == index - 1; }
  /// Returns the number of runs in the shard.
  std::size_t run_count(const CampaignPlan& prepared) const;
  void check() const;  ///< throws InputError if `index` is not in 1 to `count`
};

/// Computing time of runs, measured on a sample.
struct RunTimeProbe {
  std::size_t runs = 0;           ///< number of trial runs
  double time_per_run = 0.0;      ///< mean computing time of a run on one thread, s
  bool last_run_stopped = false;  ///< true if the last trial run was stopped early
  /// Message of the first failed trial run; empty if none failed.
  std::string first_failure = {};
  /// True if a stopped run was extrapolated to its time limit, so that `each` is an upper bound.
  bool is_upper_bound = false;
  /// Runouts of the completed trial runs, m. They are measured along `downslope` if given;
  /// otherwise, they are horizontal distances.
  std::vector<double> runouts = {};
};
/// Measures the computing time of a sample of runs. It simulates at least one run until `budget`
/// (s) is exceeded. A run of several times the budget is stopped. Results are discarded.
/// @throws InputError  if more memory is needed than is free
RunTimeProbe measure_run_time(const CampaignPlan& prepared, double budget);
/// Computes the planned power from the trial runs. Empty for persistent blocks.
PlannedPower compute_planned_power(const CampaignPlan& prepared, const RunTimeProbe& probe);
/// Estimates the computing time of a shard on the given number of threads, s.
double estimate_time(const CampaignPlan& prepared, const RunTimeProbe& probe, const Shard& shard,
                     unsigned threads);

struct CampaignRunOptions {
  unsigned threads = 0;  ///< number of threads; 0: one per core
  /// If true, an interrupted campaign is resumed, or started if there is none. If false, the runs
  /// of an interrupted campaign are discarded.
  bool resume = false;
  /// If true, finished results in the target are replaced; otherwise, they are an error. Resuming a
  /// finished campaign has no effect.
  bool replace = false;
  Shard shard = {};
  /// Processes that share the runs; only the leader writes results. If null, this process is alone.
  ProcessTeam* team = nullptr;
  /// Called with the numbers of finished and planned runs after each run, and during long
  /// realisations. Calls may come from any thread, one at a time.
  ProgressCallback progress = {};
  /// Wall-clock interval between checkpoints of a realisation of persistent blocks, s. It is at
  /// least 20 times the writing time. If 0, checkpoints are only written when `progress` ends the
  /// campaign.
  double checkpoint_interval = 300.0;
};

/// Simulates all runs that are not stored yet and writes `target`. Failed runs are stored with stop
/// reason `error` and their message. The datasets do not depend on the number of threads or
/// processes, or on interruptions. If `progress` throws, current runs are finished and kept, and
/// checkpoints of realisations are written. `resume` continues from these. In a team, only the
/// leader calls `progress`, and the checkpoints of other processes need a shared file system.
/// @throws InputError  if the target cannot be written or has results that must be kept, if the
///                     journal belongs to another campaign or shard, if a checkpoint is damaged, or
///                     if more memory is needed than is free
void run_campaign(const CampaignPlan& prepared, const std::filesystem::path& target,
                  const CampaignRunOptions& options = {});

}  // namespace clast
