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

/// Initial state of the blocks of a simultaneous release in one realisation.
struct MultiBlockStart {
  std::size_t blocks = 0;
  double volume = 0.0;  ///< solid volume of the blocks, m^3
  double mass = 0.0;    ///< kg
  double area = 0.0;  ///< area of the outline, m^2; it and the following members are for heaps only
  double mean_thickness = 0.0;     ///< mean height above the ground over the outline, m
  double largest_thickness = 0.0;  ///< largest height above the ground, m

  /// Returns the solid fraction of the heap: volume of the blocks divided by the volume between
  /// ground and top.
  double solid_fraction() const { return volume / (area * mean_thickness); }
};

/// Prepared campaign: loaded inputs, planned runs and all settings.
struct CampaignPlan {
  Campaign campaign;
  CampaignHeader header;
  CampaignBlocks choice;
  BlockBodies bodies;                     ///< bodies of `choice.blocks`
  std::optional<TerrainSurface> surface;  ///< contact surface of the terrain
  /// Planned runs, in the order in which they are numbered.
  std::vector<RunRecord> runs;
  std::vector<MultiBlockStart> masses;  ///< initial states of simultaneous releases, by realisation
};

/// Returns the simulation settings of a campaign, with stiffness and time step of a run.
MotionSettings motion_settings(const Campaign& campaign, const RunRecord& run);
ReleaseSettings release_settings(const Campaign& campaign, const RunRecord& run);

/// Prepares a campaign: loads library and terrain, varies and places blocks, and checks all starts.
/// @throws InputError  if inputs are inconsistent, for example if a zone has no parameters or a
///                     point is outside the terrain
/// @throws SimulationError  if a start is in the ground; names block, point, orientation and depth
/// @throws GeometryError  if a body of `vary` in [blocks] cannot be made
CampaignPlan prepare_campaign(const Campaign& campaign,
                              const BlockPreparationOptions& preparation = {});

/// Samples the blocks of a prepared campaign again, with its present settings. Library and runs are
/// unchanged.
/// @throws InputError  if `sample_blocks` throws
void resample_blocks(CampaignPlan& prepared);

/// Shard: every n-th run or realisation of a campaign, for n independent jobs.
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

/// Processor time of the runs of a campaign, measured on trial runs.
struct RunTimeProbe {
  std::size_t runs = 0;           ///< number of trial runs
  double time_per_run = 0.0;      ///< mean processor time of a run on one thread, s
  bool last_run_stopped = false;  ///< true if the last trial run was stopped early
  /// Message of the first failed trial run; empty if none failed.
  std::string first_failure = {};
  /// True if a stopped run was extrapolated to its time limit, so that `time_per_run` is an upper
  /// bound.
  bool is_upper_bound = false;
  /// Runouts of the completed trial runs, m.
  std::vector<double> runouts = {};
};
/// Measures the computing time of runs on a few trial runs, until `budget` (s) is exceeded. A run
/// that takes five times as long is stopped; if its blocks are released together, the rest of its
/// computing time is estimated from single releases of some of them.
/// @throws InputError  if more memory is needed than is free
RunTimeProbe measure_run_time(const CampaignPlan& prepared, double budget);
/// Computes the planned statistical power of a campaign from trial runs. Unknown for persistent
/// blocks.
PlannedPower compute_planned_power(const CampaignPlan& prepared, const RunTimeProbe& probe);
/// Estimates the computing time of a shard on the given number of idle cores, s.
double estimate_time(const CampaignPlan& prepared, const RunTimeProbe& probe, const Shard& shard,
                     unsigned threads);

struct CampaignRunOptions {
  unsigned threads = 0;  ///< number of threads; 0: one per core
  /// True if an interrupted campaign is resumed; false if its runs are discarded.
  bool resume = false;
  /// True if finished results in the target are replaced; otherwise, they are an error.
  bool replace = false;
  Shard shard = {};
  /// Processes that share the runs; null for a single process.
  ProcessTeam* team = nullptr;
  /// Function called after each run and during long realisations, from any thread, one call at a
  /// time.
  ProgressCallback progress = {};
  /// Interval of computing time between checkpoints of a realisation, s. If 0, checkpoints are only
  /// written when the campaign is interrupted.
  double checkpoint_interval = 300.0;
};

/// Simulates all runs that are not stored yet and writes the results file. Failed runs are stored
/// with their message. The results do not depend on the number of threads or processes, or on
/// interruptions. If `progress` throws, current runs are finished and kept.
/// @throws InputError  if the target cannot be written or has results that must be kept, if the
///                     journal belongs to another campaign or shard, if a checkpoint is damaged, or
///                     if more memory is needed than is free
void run_campaign(const CampaignPlan& prepared, const std::filesystem::path& target,
                  const CampaignRunOptions& options = {});

}  // namespace clast
