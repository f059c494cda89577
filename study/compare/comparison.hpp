#pragma once
/// Comparison of the runs of one or more campaigns, by block and by shape class.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/statistics/statistics.hpp"
#include "study/compare/differences.hpp"
#include "study/compare/measured_stops.hpp"
#include "study/results/results.hpp"

namespace clast {

/// One run of a comparison: a row of runs.csv. Positions are in map coordinates, m.
struct RunRow {
  std::uint32_t file = 0;  ///< index into Comparison::results
  const RunRecord* record = nullptr;
  const BlockSummary* block = nullptr;
  Vec3 start = Vec3::Zero();
  Vec3 stop = Vec3::Zero();
  double runout = 0.0;   ///< distance along the downslope direction, m
  double lateral = 0.0;  ///< lateral angle, rad; positive to the right looking downslope
};

enum class RunGroupKind { kAll, kBlock, kGarcia, kSneedFolk, kColumn };

/// Group of runs: all runs, or the runs of one block, one shape class or one column value. Examples
/// of names are "all", "block SP1A", "class compact" and "sneed-folk VE". With several results
/// files, each group exists once over all files and once per file ("file 1: block SP1A"). Files are
/// numbered from 1 in the given order.
struct RunGroup {
  std::string name;  ///< with the file, if the group belongs to one file: "file 1: block SP1A"
  RunGroupKind kind = RunGroupKind::kAll;
  std::string key;     ///< block id, class name or column value; empty for "all"
  std::string column;  ///< name of the column, if `kind` is kColumn
  std::optional<std::uint32_t>
      file;  ///< index into Comparison::results; empty for a group over all files
  std::vector<std::size_t> rows;  ///< indices into Comparison::rows
};

/// Barrier line in map coordinates. Barriers of several files with equal name and line are one
/// barrier. A ring (closed line) gives two barriers, one for entries and one for exits.
struct BarrierLine {
  enum class Counts { kEither, kForward, kEntries, kExits };
  std::string name;  ///< with suffix " (file 2)" if lines of one name differ; rings end in " (in)"
                     ///< or " (out)"
  std::vector<Vec2> vertices;        ///< vertices of the line, map, m
  std::vector<std::uint32_t> files;  ///< files that contain the barrier
  Counts counts = Counts::kEither;

  /// Direction of a crossing: "forward" or "backward"; for rings "in" or "out".
  std::string direction(const Crossing& crossing) const;
  /// Counted direction: "either", "forward", "in" or "out".
  std::string counted_direction() const;
  /// True if the crossing has the direction of `counted_direction`.
  bool counted(const Crossing& crossing) const;
  bool is_in(std::uint32_t file) const;
  bool belongs_to_ring() const { return counts == Counts::kEntries || counts == Counts::kExits; }
};

/// One crossing of a barrier: a row of crossings.csv.
struct BarrierCrossing {
  const Crossing* crossing = nullptr;
  std::size_t row = 0;           ///< index into Comparison::rows
  std::size_t barrier = 0;       ///< index into Comparison::lines
  Vec3 position = Vec3::Zero();  ///< map, m
  bool counted =
      false;  ///< true for the run's first crossing of this barrier in the counted direction
};

/// Statistics of one group at one barrier, over the counted crossings.
struct BarrierGroupStatistics {
  std::string barrier;
  std::string group;
  std::string counted;          ///< result of `BarrierLine::counted_direction`
  std::size_t line = 0;         ///< index into Comparison::lines
  std::size_t group_index = 0;  ///< index into Comparison::groups
  std::size_t started = 0;      ///< number of runs without error, in files that contain the barrier
  std::size_t crossed = 0;      ///< number of runs with a counted crossing
  std::size_t backward = 0;     ///< number of runs whose first crossing is backward; 0 for rings
  double probability = 0.0;
  /// 95 % interval of probability (`clustered_proportion_interval`); empty for one realisation.
  std::optional<Interval> interval;
  Summary height, clearance, speed;  ///< m, m, m/s
  Summary top;  ///< height of the centre plus largest radius of the block, m: an upper bound of the
                ///< height of the block's surface above the ground
  Summary translational, rotational, total;  ///< J
  Summary rotation_rate;                     ///< rad/s
};

/// Number of runs by stop reason.
struct StopCounts {
  std::size_t rest = 0;
  std::size_t left_terrain = 0;
  std::size_t max_time = 0;
  std::size_t error = 0;
};

/// Runout statistics of the runs of a group that came to rest; other runs are only counted.
struct DepositStatistics {
  std::size_t started = 0;
  StopCounts stops;
  Summary runout;                 ///< m
  Summary lateral;                ///< rad
  Vec3 mean_stop = Vec3::Zero();  ///< map, m
};

/// Returns the cluster of a run. Runs of one cluster are statistically dependent. If blocks are
/// persistent, a cluster is one realisation; otherwise, it is one release point.
std::uint32_t cluster_index_of_run(const CampaignResults& results, const RunRecord& run);

/// Numbers the clusters of `cluster_index_of_run` over all files.
class RunClustering {
 public:
  explicit RunClustering(const std::vector<CampaignResults>& results) : results_(results) {}

  std::uint32_t of(const RunRow& row);
  std::size_t count() const { return numbers_.size(); }
  /// True if the runs include persistent blocks and these belong to a single realisation. Such runs
  /// depend on each other, so neither intervals nor tests are possible.
  bool has_single_realisation() const { return realisations_ == 1; }

 private:
  const std::vector<CampaignResults>& results_;
  std::size_t realisations_ = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
};

/// Returns the name of the release set of a point; empty if there is only one set.
const std::string& find_release_set(const CampaignResults& results, std::uint32_t point);

/// Warning about a fault that could reverse a conclusion.
struct ComparisonWarning {
  std::string brief;               ///< one sentence
  std::vector<std::string> texts;  ///< full texts of the warnings
};

/// Runs, groups and statistics from which tables and reports are made. Rows point into `results`,
/// so a comparison can be moved but not copied.
struct Comparison {
  Comparison() = default;
  Comparison(Comparison&&) = default;
  Comparison& operator=(Comparison&&) = default;

  std::vector<CampaignResults> results;
  Vec2 downslope = Vec2::UnitX();  ///< unit vector: the direction given in the campaign, or that of
                                   ///< the mean displacement from release to stop
  bool downslope_given = false;
  std::vector<RunRow> rows;  ///< in order of file and run
  std::vector<RunGroup> groups;
  std::vector<DepositStatistics> deposits;  ///< one entry per group
  std::vector<BarrierLine> lines;
  std::vector<BarrierCrossing> crossings;  ///< in order of file, run and time
  std::vector<BarrierGroupStatistics>
      barriers;  ///< ordered by barrier, then group; groups without a crossing are omitted
  std::vector<GroupDifference> differences;
  std::optional<MeasuredStops> measured;  ///< table of stops observed in the field
  std::optional<double>
      margin;  ///< equivalence margin: smaller differences in runout do not matter, m
  std::vector<std::string> warnings;  ///< for example "mass differs between classes"
  std::vector<ComparisonWarning>
      cautions;  ///< warnings about faults that could reverse a conclusion
};

/// Returns the counted crossing of a barrier for each row of the comparison. The pointer is null if
/// the run has no counted crossing.
std::vector<const Crossing*> find_counted_crossings(const Comparison& comparison, std::size_t line);

struct ComparisonOptions {
  std::vector<std::string>
      by;  ///< names of columns of `run_columns`; runs are also grouped by their values
  std::optional<std::filesystem::path> measured;  ///< table of stops observed in the field
  std::optional<double>
      margin;  ///< equivalence margin: smaller differences in runout do not matter, m

  void check() const;  ///< throws InputError if the margin is not positive
};

/// Groups the runs and computes the statistics of groups and barriers.
/// @throws InputError  if there are no runs, terrains have different map frames, downslope
///                     directions differ, records are inconsistent (a damaged file), a column does
///                     not exist, or the measured stops cannot be read
Comparison compare(std::vector<CampaignResults> results, const ComparisonOptions& options = {});

/// Returns the reassigned energy as a fraction of the dissipated energy. Energy is reassigned (lost
/// or gained) if contacts or their weights change. Empty if nothing was dissipated.
std::optional<double> reassigned_energy_fraction(const EnergyBalance& energy);
/// Limit of `reassigned_energy_fraction` above which a warning is given. A fraction of 10 % has the
/// effect of a 10 % change of friction, and surveys rarely determine friction more accurately. Most
/// runs have a few per cent.
inline constexpr double kNotableReassignedFraction = 0.1;

/// Adds warnings about failed or lost runs, unequal masses and poor energy balance to `warnings`
/// and `cautions`. Deviations that the campaign requests are not reported. Called by `compare`.
void add_comparison_warnings(Comparison& comparison);

}  // namespace clast
