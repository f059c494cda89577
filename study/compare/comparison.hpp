#pragma once
/// Runs of one or more campaigns side by side, by block and by shape class.
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

/// One row of runs.csv. Positions are on the map.
struct RunRow {
  std::uint32_t file = 0;  ///< which results file
  const RunRecord* record = nullptr;
  const BlockSummary* block = nullptr;
  Vec3 start = Vec3::Zero();
  Vec3 stop = Vec3::Zero();
  double runout = 0.0;   ///< m, along downslope
  double lateral = 0.0;  ///< rad, + to the right looking downslope
};

/// By what the runs of a group belong together.
enum class GroupKind { kAll, kBlock, kGarcia, kSneedFolk, kColumn };

/// Runs of a group: "all", one block ("block SP1A"), or one class ("class compact",
/// "sneed-folk VE"). With several results files every group comes once over all files and once per
/// file ("file 1: block SP1A"; files are numbered from 1 in the order they were given).
struct Group {
  std::string name;
  GroupKind kind = GroupKind::kAll;
  std::string key;                    ///< block id, class name or value; empty for all
  std::string column;                 ///< of kColumn: what was asked for
  std::optional<std::uint32_t> file;  ///< index, when the group is of one file only
  std::vector<std::size_t> rows;      ///< into Comparison::rows
};

/// A barrier on the map. The same name and line in several files is one barrier; a ring is two, of
/// entries and of exits.
struct BarrierLine {
  enum class Counts { kEither, kForward, kEntries, kExits };
  std::string name;  ///< made unique by " (file 2)" where lines differ; of a ring with " (in)" or
                     ///< " (out)"
  std::vector<Vec2> through;         ///< map, m
  std::vector<std::uint32_t> files;  ///< that have it
  Counts counts = Counts::kEither;

  /// "forward" or "backward"; of a ring "in" or "out".
  std::string direction(const Crossing& crossing) const;
  /// What counts: "either", "forward", "in" or "out".
  std::string counted_direction() const;
  /// A crossing that way.
  bool counted(const Crossing& crossing) const;
  bool is_in(std::uint32_t file) const;
  bool of_ring() const { return counts == Counts::kEntries || counts == Counts::kExits; }
};

/// One row of crossings.csv.
struct BarrierCrossing {
  const Crossing* crossing = nullptr;
  std::size_t row = 0;           ///< into Comparison::rows
  std::size_t barrier = 0;       ///< into Comparison::lines
  Vec3 position = Vec3::Zero();  ///< map, m
  bool counted = false;          ///< this run's first crossing of this barrier, the way it counts
};

/// Runs of one group at one barrier. Summaries are over counted crossings.
struct BarrierGroupStatistics {
  std::string barrier;
  std::string group;
  std::string counted;          ///< as `BarrierLine::counted_direction`
  std::size_t line = 0;         ///< into Comparison::lines
  std::size_t group_index = 0;  ///< into Comparison::groups
  std::size_t started = 0;      ///< runs of the group, in files with the barrier, that did not fail
  std::size_t crossed = 0;
  std::size_t backward = 0;  ///< runs that passed backward first, counted or not; of a ring none
  double probability = 0.0;
  /// 95 %, of the probability, as `clustered_proportion_interval`; none of one realisation.
  std::optional<Interval> interval;
  Summary height, clearance, speed;  ///< m, m, m/s
  Summary top;  ///< no skin point is higher above that ground, m: height and farthest skin point
  Summary translational, rotational, total;  ///< J
  Summary rotation_rate;                     ///< rad/s
};

/// How runs ended.
struct StopCounts {
  std::size_t rest = 0;
  std::size_t left_terrain = 0;
  std::size_t max_time = 0;
  std::size_t error = 0;
};

/// Where the runs of a group came to rest. Runs that ended otherwise are counted only.
struct DepositStatistics {
  std::size_t started = 0;
  StopCounts stops;
  Summary runout;                 ///< m
  Summary lateral;                ///< rad
  Vec3 mean_stop = Vec3::Zero();  ///< map, m
};

/// Runs with the same number depend on each other: those of a realisation, where blocks stay, else
/// those from one release point, which share its ground.
std::uint32_t find_cluster(const CampaignResults& results, const RunRecord& run);

/// Those clusters, numbered over all files.
class RunClustering {
 public:
  explicit RunClustering(const std::vector<CampaignResults>& results) : results_(results) {}

  std::uint32_t of(const RunRow& row);
  std::size_t count() const { return numbers_.size(); }
  /// True if blocks that stay are among the runs, of one realisation only. They depend on each
  /// other, so that nothing is known of chance: neither an interval nor a test can be given.
  bool has_single_realisation() const { return realisations_ == 1; }

 private:
  const std::vector<CampaignResults>& results_;
  std::size_t realisations_ = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
};

/// Name of the release set of a point; empty where there is one set.
const std::string& find_release_set(const CampaignResults& results, std::uint32_t point);

/// A warning that could turn an answer round.
struct ComparisonWarning {
  std::string brief;               ///< a sentence
  std::vector<std::string> texts;  ///< the warnings in full
};

/// Everything the tables and the report are made from. Rows point into `results`: moved, not
/// copied.
struct Comparison {
  Comparison() = default;
  Comparison(Comparison&&) = default;
  Comparison& operator=(Comparison&&) = default;

  std::vector<CampaignResults> results;
  Vec2 downslope = Vec2::UnitX();  ///< unit; as asked for, else along the mean release-to-stop line
  bool downslope_asked = false;
  std::vector<RunRow> rows;  ///< in order of file and run
  std::vector<Group> groups;
  std::vector<DepositStatistics> deposits;  ///< of every group
  std::vector<BarrierLine> lines;
  std::vector<BarrierCrossing> crossings;  ///< in order of file, run and time
  std::vector<BarrierGroupStatistics>
      barriers;  ///< by barrier, then group; groups that never met it left out
  std::vector<Difference> differences;
  std::optional<MeasuredStops> measured;
  std::optional<double> margin;       ///< as asked for
  std::vector<std::string> warnings;  ///< for example "mass differs between classes"
  std::vector<ComparisonWarning> cautions;      ///< of the warnings
};

/// The crossing of a barrier that counts, for each row of the comparison; null where a run has
/// none.
std::vector<const Crossing*> parse_counted_direction(const Comparison& comparison, std::size_t line);

/// What to compare beyond blocks and classes.
struct CompareOptions {
  std::vector<std::string> by;  ///< columns of `run_columns` whose values make groups
  std::optional<std::filesystem::path> measured;  ///< table of stops seen in the field
  std::optional<double> margin;  ///< differences in runout up to this do not matter, m

  void check() const;  ///< throws InputError naming the margin that is not positive
};

/// @throws InputError  no runs; results on terrains with different map frames or asking for
///                     different downslope directions; records that do not fit together (a damaged
///                     file); a column that there is not; measured stops that can't be read
Comparison compare(std::vector<CampaignResults> results, const CompareOptions& options = {});

/// How much of the energy that a run dissipates is lost or gained where contacts or weights change;
/// none when it dissipates nothing.
std::optional<double> reassigned_energy_fraction(const EnergyLedger& energy);
/// Runs above this share are warned of. It acts like that much more or less friction, which surveys
/// rarely know to 10 %; a few per cent are the price of contacts that begin and end, in most runs.
inline constexpr double kNotableReassigned = 0.1;

/// Adds what a reader of the tables must know to `warnings` and `cautions`: unfinished or lost
/// runs, unequal masses, poor energy balance. What the campaign asked for is no warning. Called by
/// `compare`.
void add_warnings(Comparison& comparison);

}  // namespace clast
