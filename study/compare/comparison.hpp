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

/// One run of a comparison: a row of runs.csv. Positions are map coordinates.
struct RunRow {
  std::uint32_t file =
      0;  ///< index into Comparison::results, if the group belongs to one file only
  const RunRecord* record = nullptr;
  const BlockSummary* block = nullptr;
  Vec3 start = Vec3::Zero();
  Vec3 stop = Vec3::Zero();
  double runout = 0.0;   ///< distance along the downslope direction, m
  double lateral = 0.0;  ///< lateral angle, rad; positive to the right looking downslope
};

enum class GroupKind { kAll, kBlock, kGarcia, kSneedFolk, kColumn };

/// Group of runs: "all", one block ("block SP1A"), or one class ("class compact", "sneed-folk VE").
/// With several results files, each group exists once over all files and once per file ("file 1:
/// block SP1A"; files are numbered from 1 in the given order).
struct Group {
  std::string
      name;  ///< with suffix " (file 2)" if lines of one name differ, " (in)" or " (out)" for rings
  GroupKind kind = GroupKind::kAll;
  std::string key;                    ///< block id, class name or column value; empty for "all"
  std::string column;                 ///< name of the column, if `kind` is kColumn
  std::optional<std::uint32_t> file;  ///< index, when the group is of one file only
  std::vector<std::size_t> rows;      ///< indices into Comparison::rows
};

/// Barrier line in map coordinates. Equal name and line in several files are one barrier; a ring is
/// two barriers, one for entries and one for exits.
struct BarrierLine {
  enum class Counts { kEither, kForward, kEntries, kExits };
  std::string name;  ///< made unique by " (file 2)" where lines differ; of a ring with " (in)" or
                     ///< " (out)"
  std::vector<Vec2> through;         ///< map, m
  std::vector<std::uint32_t> files;  ///< files that contain the barrier
  Counts counts = Counts::kEither;

  /// Direction of a crossing: "forward" or "backward"; for rings "in" or "out".
  std::string direction(const Crossing& crossing) const;
  /// Counted direction: "either", "forward", "in" or "out".
  std::string counted_direction() const;
  /// True if the crossing has the counted direction.
  bool counted(const Crossing& crossing) const;  ///< `BarrierLine::counted_direction`
  bool is_in(std::uint32_t file) const;
  bool of_ring() const { return counts == Counts::kEntries || counts == Counts::kExits; }
};

/// One crossing of a barrier: a row of crossings.csv.
struct BarrierCrossing {
  const Crossing* crossing = nullptr;
  std::size_t row = 0;           ///< index into Comparison::rows
  std::size_t barrier = 0;       ///< index into Comparison::lines
  Vec3 position = Vec3::Zero();  ///< map, m
  bool counted = false;          ///< this run's first crossing of this barrier, the way it counts
};

/// Statistics of one group at one barrier, over the counted crossings.
struct BarrierGroupStatistics {
  std::string barrier;
  std::string group;
  std::string counted;          ///< as `BarrierLine::counted_direction`
  std::size_t line = 0;         ///< index into Comparison::lines
  std::size_t group_index = 0;  ///< index into Comparison::groups
  std::size_t started = 0;      ///< number of runs without error, in files that contain the barrier
  std::size_t crossed = 0;      ///< number of runs with a counted crossing
  std::size_t backward = 0;  ///< runs whose first crossing is backward, counted or not; 0 for rings
  double probability = 0.0;
  /// 95 % interval of the probability (`clustered_proportion_interval`); empty for a single
  /// realisation.
  std::optional<Interval> interval;
  Summary height, clearance, speed;  ///< m, m, m/s
  Summary top;  ///< upper bound of the height of any surface point above the ground, m: centre
                ///< height plus largest radius
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

/// Returns the cluster of a run. Runs of one cluster are statistically dependent: the runs of one
/// realisation if blocks are persistent, otherwise the runs of one release point, which share its
/// ground.
std::uint32_t find_cluster(const CampaignResults& results, const RunRecord& run);

/// Numbers the clusters of `find_cluster` over all files.
class RunClustering {
 public:
  explicit RunClustering(const std::vector<CampaignResults>& results) : results_(results) {}

  std::uint32_t of(const RunRow& row);
  std::size_t count() const { return numbers_.size(); }
  /// True if the runs include persistent blocks of a single realisation. They depend on each other,
  /// so that neither intervals nor tests are possible.
  bool has_single_realisation() const { return realisations_ == 1; }

 private:
  const std::vector<CampaignResults>& results_;
  std::size_t realisations_ = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
};

/// Returns the name of the release set of a point; empty if there is only one set.
const std::string& find_release_set(const CampaignResults& results, std::uint32_t point);

/// Warning that could reverse a result.
struct ComparisonWarning {
  std::string brief;               ///< one sentence
  std::vector<std::string> texts;  ///< full texts of the warnings
};

/// Runs, groups and statistics from which tables and reports are made. Rows point into `results`: a
/// comparison can be moved but not copied.
struct Comparison {
  Comparison() = default;
  Comparison(Comparison&&) = default;
  Comparison& operator=(Comparison&&) = default;

  std::vector<CampaignResults> results;
  Vec2 downslope =
      Vec2::UnitX();  ///< unit vector; as requested, or along the mean line from release to stop
  bool downslope_asked = false;
  std::vector<RunRow> rows;  ///< in order of file and run
  std::vector<Group> groups;
  std::vector<DepositStatistics> deposits;  ///< one entry per group
  std::vector<BarrierLine> lines;
  std::vector<BarrierCrossing> crossings;  ///< in order of file, run and time
  std::vector<BarrierGroupStatistics>
      barriers;  ///< by barrier, then group; groups without a crossing are omitted
  std::vector<Difference> differences;
  std::optional<MeasuredStops> measured;    ///< table of stops observed in the field
  std::optional<double> margin;             ///< equivalence margin of runout differences, m
  std::vector<std::string> warnings;        ///< for example "mass differs between classes"
  std::vector<ComparisonWarning> cautions;  ///< warnings that could reverse a result
};

/// Returns, for each row of the comparison, its counted crossing of a barrier; null if the run has
/// none.
std::vector<const Crossing*> find_counted_crossings(const Comparison& comparison, std::size_t line);

struct CompareOptions {
  std::vector<std::string> by;  ///< columns of `run_columns` whose values define groups
  std::optional<std::filesystem::path> measured;  ///< table of stops seen in the field
  std::optional<double> margin;  ///< differences in runout up to this do not matter, m

  void check() const;  ///< throws InputError naming the margin that is not positive
};

/// Groups the runs and computes all statistics.
/// @throws InputError  if there are no runs, terrains have different map frames, downslope
///                     directions differ, records are inconsistent (a damaged file), a column does
///                     not exist, or the measured stops cannot be read
Comparison compare(std::vector<CampaignResults> results, const CompareOptions& options = {});

/// Returns the energy lost or gained by changes of contacts and of contact weights, as a fraction
/// of the dissipated energy; empty if nothing was dissipated.
std::optional<double> reassigned_energy_fraction(const EnergyBalance& energy);
/// Limit of `reassigned_energy_fraction` above which a warning is given. The effect equals that of
/// as much more or less friction, which surveys rarely know to 10 %; most runs have a few per cent,
/// due to contacts that begin and end.
inline constexpr double kNotableReassigned = 0.1;

/// Adds warnings about failed or lost runs, unequal masses and poor energy balance to `warnings`
/// and `cautions`. Settings that the campaign requested are not reported. Called by `compare`.
void add_warnings(Comparison& comparison);

}  // namespace clast
