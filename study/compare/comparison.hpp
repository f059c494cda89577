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

/// One run of a comparison. Positions are in map coordinates, m.
struct RunRow {
  std::uint32_t file = 0;  ///< index into Comparison::results
  const RunRecord* record = nullptr;
  const BlockSummary* block = nullptr;
  Vec3 start = Vec3::Zero();
  Vec3 stop = Vec3::Zero();
  double runout = 0.0;   ///< runout: distance along the downslope direction, m
  double lateral = 0.0;  ///< lateral angle, rad; positive to the right looking downslope
};

enum class RunGroupKind { kAll, kBlock, kGarcia, kSneedFolk, kColumn };

/// Group of runs: all runs, or the runs of one block, one shape class or one column value. If there
/// are several results files, there is one group for all files and one for each file.
struct RunGroup {
  std::string name;  ///< name, such as "all", "class compact" or "file 1: block SP1A"
  RunGroupKind kind = RunGroupKind::kAll;
  std::string key;     ///< block id, class name or column value; empty for "all"
  std::string column;  ///< name of the column for groups of one column value
  /// Index into Comparison::results; empty for a group over all files.
  std::optional<std::uint32_t> file;
  std::vector<std::size_t> rows;  ///< indices into Comparison::rows
};

/// Barrier of a comparison, in map coordinates. Equal barriers of several files are merged. A ring
/// (closed line) gives two barriers, one for entries and one for exits.
struct BarrierLine {
  enum class Counts { kEither, kForward, kEntries, kExits };
  /// Name, with suffix " (in)" or " (out)" for rings, and " (file 2)" if barriers of one name
  /// differ.
  std::string name;
  std::vector<Vec2> vertices;        ///< vertices of the line, map, m
  std::vector<std::uint32_t> files;  ///< files that contain the barrier
  Counts counts = Counts::kEither;

  /// Returns the direction of a crossing: "forward" or "backward"; for rings "in" or "out".
  std::string direction(const Crossing& crossing) const;
  /// Returns the direction in which crossings are counted: "either", "forward", "in" or "out".
  std::string counted_direction() const;
  /// True if the crossing has the direction in which crossings are counted.
  bool counted(const Crossing& crossing) const;
  bool is_in(std::uint32_t file) const;
  bool belongs_to_ring() const { return counts == Counts::kEntries || counts == Counts::kExits; }
};

/// One crossing of a barrier by the block of a run.
struct BarrierCrossing {
  const Crossing* crossing = nullptr;
  std::size_t row = 0;           ///< index into Comparison::rows
  std::size_t barrier = 0;       ///< index into Comparison::lines
  Vec3 position = Vec3::Zero();  ///< position in map coordinates, m
  /// True for the run's first crossing of this barrier in the counted direction.
  bool counted = false;
};

/// Statistics of the counted crossings of one barrier by the runs of one group.
struct BarrierGroupStatistics {
  std::string barrier;
  std::string group;
  std::string counted;          ///< counted direction, such as "forward"
  std::size_t line = 0;         ///< index into Comparison::lines
  std::size_t group_index = 0;  ///< index into Comparison::groups
  std::size_t started = 0;      ///< number of runs without error, in files that contain the barrier
  std::size_t crossed = 0;      ///< number of runs with a counted crossing
  std::size_t backward = 0;     ///< number of runs whose first crossing is backward; 0 for rings
  double probability = 0.0;
  /// 95 % confidence interval of `probability`; empty for one realisation.
  std::optional<Interval> interval;
  /// Height of the centre, m; height of the lowest surface point, m; speed, m/s.
  SampleSummary height, clearance, speed;
  SampleSummary top;  ///< upper bound of the height of the block surface above the ground, m
  SampleSummary translational, rotational, total;  ///< kinetic energies, J
  SampleSummary rotation_rate;                     ///< angular speed, rad/s
};

/// Number of runs of a group by stop reason.
struct StopCounts {
  std::size_t rest = 0;
  std::size_t left_terrain = 0;
  std::size_t max_time = 0;
  std::size_t error = 0;
};

/// Runout statistics of the runs of a group that came to rest, and numbers of all runs by stop
/// reason.
struct DepositStatistics {
  std::size_t started = 0;
  StopCounts stops;
  SampleSummary runout;           ///< runout, m
  SampleSummary lateral;          ///< lateral angle, rad
  Vec3 mean_stop = Vec3::Zero();  ///< mean stop position, map coordinates, m
};

/// Returns the index of the cluster of a run. Runs of one cluster are statistically dependent. A
/// cluster is one release point, or one realisation of persistent blocks.
std::uint32_t cluster_index_of_run(const CampaignResults& results, const RunRecord& run);

/// Numbers the clusters of statistically dependent runs over all results files.
class RunClustering {
 public:
  explicit RunClustering(const std::vector<CampaignResults>& results) : results_(results) {}

  std::uint32_t of(const RunRow& row);
  std::size_t count() const { return numbers_.size(); }
  /// True if persistent blocks belong to a single realisation. Their runs depend on each other, so
  /// neither intervals nor tests are possible.
  bool has_single_realisation() const { return realisations_ == 1; }

 private:
  const std::vector<CampaignResults>& results_;
  std::size_t realisations_ = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
};

/// Returns the name of the release set of a point; empty if there is only one set.
const std::string& find_release_set(const CampaignResults& results, std::uint32_t point);

/// Warning about a fault that could reverse the conclusions of a comparison.
struct ComparisonWarning {
  std::string brief;               ///< warning in one sentence
  std::vector<std::string> texts;  ///< full texts of the warning, one per fault
};

/// Comparison of campaigns: runs, groups and statistics for tables and reports. It can be moved but
/// not copied, because rows point into `results`.
struct Comparison {
  Comparison() = default;
  Comparison(Comparison&&) = default;
  Comparison& operator=(Comparison&&) = default;

  std::vector<CampaignResults> results;
  /// Unit vector: direction given in the campaign, or that of the mean displacement.
  Vec2 downslope = Vec2::UnitX();
  bool downslope_given = false;
  std::vector<RunRow> rows;  ///< runs in order of file and run
  std::vector<RunGroup> groups;
  std::vector<DepositStatistics> deposits;  ///< runout statistics, one entry per group
  std::vector<BarrierLine> lines;
  std::vector<BarrierCrossing> crossings;  ///< crossings in order of file, run and time
  /// Statistics ordered by barrier, then group; groups without a crossing are omitted.
  std::vector<BarrierGroupStatistics> barriers;
  std::vector<GroupDifference> differences;
  std::optional<MeasuredStops> measured;  ///< table of stops observed in the field
  /// Equivalence margin: smaller differences in runout do not matter, m.
  std::optional<double> margin;
  std::vector<std::string> warnings;  ///< warnings, such as "mass differs between classes"
  /// Warnings about faults that could reverse a conclusion.
  std::vector<ComparisonWarning> cautions;
};

/// Finds the counted crossing of a barrier for each run of the comparison; null if the run has
/// none.
std::vector<const Crossing*> find_counted_crossings(const Comparison& comparison, std::size_t line);

struct ComparisonOptions {
  /// Names of columns of runs.csv; runs are also grouped by their values.
  std::vector<std::string> by;
  std::optional<std::filesystem::path> measured;  ///< table of stops observed in the field
  /// Equivalence margin: smaller differences in runout do not matter, m.
  std::optional<double> margin;

  void check() const;  ///< throws InputError if the margin is not positive
};

/// Compares the runs of campaigns: groups the runs and computes the statistics of groups and
/// barriers.
/// @throws InputError  if there are no runs, map frames or downslope directions differ, a column
///                     does not exist, or the measured stops cannot be read
Comparison compare(std::vector<CampaignResults> results, const ComparisonOptions& options = {});

/// Returns the energy lost or gained because contacts or their weights changed, as a fraction of
/// the dissipated energy. Empty if nothing was dissipated.
std::optional<double> reassigned_energy_fraction(const EnergyBalance& energy);
/// Limit of `reassigned_energy_fraction` above which a warning is given. A fraction of 10 % has the
/// effect of a 10 % change of friction.
inline constexpr double kNotableReassignedFraction = 0.1;

/// Adds warnings about failed or lost runs, unequal masses and poor energy balance to a comparison.
/// Called by `compare`.
void add_comparison_warnings(Comparison& comparison);

}  // namespace clast
