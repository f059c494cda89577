#pragma once
/// Runs a campaign.
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

/// What the blocks of a mass start as, of one realisation.
struct MultiBlockStart {
  std::size_t blocks = 0;
  double volume = 0.0;             ///< of the blocks, m^3
  double mass = 0.0;               ///< kg
  double area = 0.0;               ///< of the polygon, m^2; this and what follows is of a heap
  double mean_thickness = 0.0;     ///< above the ground, over the polygon, m
  double largest_thickness = 0.0;  ///< m

  /// Share of the space between ground and top of the heap that blocks fill.
  double solid_fraction() const { return volume / (area * mean_thickness); }
};

/// A campaign with its inputs loaded and everything decided: what would run, and how.
struct CampaignPlan {
  Campaign campaign;
  CampaignHeader header;
  BlockChoice choice;
  BlockBodies bodies;                     ///< of `choice.blocks`
  std::optional<TerrainSurface> surface;  ///< of `header.terrain`; always there
  /// Planned runs in order: blocks, release sets, their points, their orientations, members of the
  /// ensemble (fastest); where blocks stay: realisations, blocks in the order of their release.
  std::vector<RunRecord> runs;    ///< with their stiffness; `result` still empty
  std::vector<MultiBlockStart> masses;  ///< of each realisation, one to each mass
};

/// What the campaign and the run itself, its stiffness and time step, ask of the dynamics.
MotionSettings motion_settings(const Campaign& campaign, const RunRecord& run);
ReleaseSettings release_settings(const Campaign& campaign, const RunRecord& run);

/// Loads library and terrain, makes bodies where blocks are varied, places every block and checks
/// every start.
/// @throws InputError       inputs that do not fit: a zone without parameters, a parameter for no
///                          zone, no block selected, a point off the terrain
/// @throws SimulationError  a start inside the ground: block, point, orientation and depth
/// @throws GeometryError    a body of [blocks] vary can't be made
CampaignPlan prepare_campaign(const Campaign& campaign, const BlockPreparationOptions& making = {});

/// Draws the blocks anew, as the campaign asks by now, out of `prepared.choice.library`, which
/// stays whole; runs are left as they are.
/// @throws InputError  as `draw_blocks`
void resample_blocks(CampaignPlan& prepared);

/// Every n-th run of a campaign, or realisation where blocks stay, so that n jobs that know nothing
/// of each other do it all: `merge_results` joins what they wrote.
struct Shard {
  std::uint32_t index = 1;  ///< from 1
  std::uint32_t count = 1;

  /// @param item  number of a run, or of a realisation
  bool has(std::uint32_t item) const { return item % count == index - 1; }
  /// How many runs of the campaign it has.
  std::size_t runs_of(const CampaignPlan& prepared) const;
  void check() const;  ///< throws InputError naming both
};

/// How long runs take, from some of them.
struct TimeProbe {
  std::size_t runs = 0;    ///< that were tried
  double each = 0.0;       ///< mean time of one on one thread, s
  bool cut_short = false;  ///< the last took too long to be waited for
  /// What the first of the tried runs that failed says; empty: none did.
  std::string failure = {};
  /// It counts as if it went on like that to the time limit, so `each` is the most to expect.
  bool at_most = false;
  /// How far those went that were not cut short: along `downslope` where it is given, else in plan,
  /// m.
  std::vector<double> runouts = {};
};
/// Tries runs from all over the campaign, one after the other, until `budget` seconds are spent,
/// or a run has taken several times that; one at least. Nothing is kept.
/// @throws InputError  more memory is needed than is free
TimeProbe probe_time(const CampaignPlan& prepared, double budget);
/// What could be told apart, judging by those runs; nothing where blocks stay.
PlannedPower planned_power(const CampaignPlan& prepared, const TimeProbe& probe);
/// How long a shard of the campaign takes on so many threads, s.
double estimate_time(const CampaignPlan& prepared, const TimeProbe& probe, const Shard& shard,
                     unsigned threads);

struct RunOptions {
  unsigned threads = 0;  ///< 0: one per core
  /// Goes on with an interrupted campaign; begins when there is none. Otherwise what an interrupted
  /// one left is replaced.
  bool resume = false;
  /// Finished results in the target are replaced; else they are kept, and the campaign refused. To
  /// resume a campaign that is finished does nothing.
  bool replace = false;
  Shard shard = {};
  /// The runs are shared among its processes; only the one that leads writes. None: this one alone.
  ProcessTeam* team = nullptr;
  /// Called after each run with runs done and planned, from any thread, one at a time; while a
  /// realisation is under way also now and then.
  ProgressCallback progress = {};
  /// Wall-clock time between two checkpoints of a realisation of blocks that stay, s, or 20 times
  /// what writing one takes; 0: one only when `progress` ends the campaign.
  double checkpoint_interval = 300.0;
};

/// Runs everything that is not stored yet and writes `target`. A run that fails is stored with stop
/// reason `error` and its message. The datasets do not depend on the number of threads or
/// processes, or on interruptions; what `progress` throws ends the campaign after the runs under
/// way, which are kept. Realisations under way are stopped; a checkpoint of each is written beside
/// the journal, and `resume` continues from it. (Of a team, only the process that leads has
/// progress; checkpoints of the others need a file system that all share.)
/// @throws InputError  the target can't be written or holds results that are kept; resuming what
///                     another campaign or shard began, or from a damaged checkpoint; more memory
///                     is needed than is free
void run_campaign(const CampaignPlan& prepared, const std::filesystem::path& target,
                  const RunOptions& options = {});

}  // namespace clast
