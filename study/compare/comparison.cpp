#include "study/compare/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "classify/schemes.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/reference_system.hpp"
#include "study/campaign/barrier_line.hpp"
#include "study/compare/detail/comparison_barriers.hpp"
#include "study/compare/run_columns.hpp"
#include "study/results/runout.hpp"

namespace clast {

using namespace study_detail;
namespace {

/// Mean release-to-stop lines shorter than this have no direction worth naming, m.
constexpr double kMinLineLength = 1e-3;

std::string label(const std::vector<CampaignResults>& results, std::size_t file) {
  const std::string path = results[file].file.string();
  return path.empty() ? "results file " + std::to_string(file + 1) : path;
}

bool finite(const Vec3& vector) { return vector.allFinite(); }

void check_run(const std::string& file, const CampaignResults& results, const RunRecord& run) {
  const std::string item = file + ": run " + std::to_string(run.run);
  if (run.block >= results.blocks.size()) {
    throw InputError(item + " refers to block number " + std::to_string(run.block) + " of " +
                     std::to_string(results.blocks.size()) +
                     "; the file is damaged; run the campaign again");
  }
  const bool measured = run.result.stop_reason != StopReason::kError;
  if (!finite(run.start.position) || (measured && !finite(run.result.final_state.position))) {
    throw InputError(item + " has a start or stop that is not a finite position; the file is " +
                     "damaged; run the campaign again");
  }
}

bool share_no_run(const CampaignResults& a, const CampaignResults& b) {
  return std::none_of(a.runs.begin(), a.runs.end(), [&](const RunRecord& run) {
    return std::binary_search(b.runs.begin(), b.runs.end(), run,
                              [](const RunRecord& x, const RunRecord& y) { return x.run < y.run; });
  });
}

/// Same inputs give the same bits, so these runs would only be counted twice.
void check_given_once(const std::vector<CampaignResults>& results, std::size_t file) {
  for (std::size_t other = 0; other < file; ++other) {
    const CampaignResults &a = results[other], &b = results[file];
    if (a.campaign_sha256 == b.campaign_sha256 && a.inputs == b.inputs &&
        a.program_version == b.program_version && a.engine == b.engine) {
      if (share_no_run(a, b)) {
        throw InputError(label(results, file) + " and " + label(results, other) +
                         ": are parts of one campaign; join all its parts first with "
                         "`merge_results`");
      }
      throw InputError(
          label(results, file) + ": holds the same runs as " + label(results, other) +
          " (same campaign, inputs and program), so these would count twice; give the file once");
    }
  }
}

void check_results(const std::vector<CampaignResults>& results) {
  std::size_t runs = 0;
  for (std::size_t file = 0; file < results.size(); ++file) {
    const CampaignResults& one = results[file];
    runs += one.runs.size();
    for (const RunRecord& run : one.runs) check_run(label(results, file), one, run);
    check_given_once(results, file);
    const MapFrame& first = results.front().frame;
    if (one.frame.origin != first.origin || one.frame.crs != first.crs) {
      std::ostringstream text;
      text.precision(12);
      text << label(results, file) << ": its map frame (origin " << one.frame.origin.transpose()
           << (one.frame.crs.empty() ? ", no CRS" : ", " + reference_system_name(one.frame.crs))
           << ") is not that of " << label(results, 0) << " (origin " << first.origin.transpose()
           << (first.crs.empty() ? ", no CRS" : ", " + reference_system_name(first.crs))
           << "); compare campaigns on the same terrain, or each site separately";
      throw InputError(text.str());
    }
  }
  if (runs == 0) {
    throw InputError(
        (results.empty() ? std::string("no results file is given") : label(results, 0)) +
        ": there are no runs to compare; run clast simulate first");
  }
}

/// The direction the files ask for. None when no file does.
std::optional<Vec2> asked_downslope(const std::vector<CampaignResults>& results) {
  std::optional<Vec2> asked;
  std::size_t asked_by = 0;
  for (std::size_t file = 0; file < results.size(); ++file) {
    if (!results[file].downslope) continue;
    const Vec2 direction = *results[file].downslope;
    if (!direction.allFinite() || direction.norm() == 0.0) {
      throw InputError(label(results, file) +
                       ": downslope is not a direction; write two numbers, " +
                       "not both zero, in [run] downslope");
    }
    const Vec2 unit = direction.normalized();
    if (asked && (unit - *asked).norm() > 1e-9) {
      throw InputError(label(results, file) + ": has another downslope direction than " +
                       label(results, asked_by) +
                       ", so their runouts cannot be compared; compare the files one by one");
    }
    if (!asked) asked_by = file;
    asked = unit;
  }
  return asked;
}

/// Along the mean line from release to stop, over all runs that did not fail.
std::optional<Vec2> mean_downslope(const std::vector<RunRow>& rows) {
  Vec2 sum = Vec2::Zero();
  std::size_t count = 0;
  for (const RunRow& row : rows) {
    if (row.record->result.stop_reason == StopReason::kError) continue;
    sum += (row.stop - row.start).head<2>();
    ++count;
  }
  if (count == 0 || sum.norm() < kMinLineLength * static_cast<double>(count)) return std::nullopt;
  return sum.normalized();
}

std::vector<RunRow> collect_rows(const std::vector<CampaignResults>& results) {
  std::vector<RunRow> rows;
  for (std::size_t file = 0; file < results.size(); ++file) {
    const CampaignResults& one = results[file];
    for (const RunRecord& run : one.runs) {
      RunRow row;
      row.file = static_cast<std::uint32_t>(file);
      row.record = &run;
      row.block = &one.blocks[run.block];
      row.start = one.frame.to_map(run.start.position);
      row.stop = one.frame.to_map(run.result.final_state.position);
      rows.push_back(row);
    }
  }
  return rows;
}

const std::string& key_of(const BlockSummary& block, RunGroupKind kind) {
  static const std::string none;
  switch (kind) {
    case RunGroupKind::kBlock:
      return block.library_block();
    case RunGroupKind::kGarcia:
      return block.garcia;
    case RunGroupKind::kSneedFolk:
      return block.sneed_folk;
    case RunGroupKind::kAll:
    case RunGroupKind::kColumn:
      break;
  }
  return none;
}

/// Keys that occur, blocks in the order of the files, classes in the order of their scheme.
std::vector<std::string> keys_in_order(const std::vector<RunRow>& rows, RunGroupKind kind) {
  std::vector<std::string> keys;
  std::set<std::string> seen;
  for (const RunRow& row : rows) {
    if (seen.insert(key_of(*row.block, kind)).second) keys.push_back(key_of(*row.block, kind));
  }
  if (kind == RunGroupKind::kAll || kind == RunGroupKind::kBlock) return keys;
  const std::vector<std::string>& order =
      class_names(kind == RunGroupKind::kGarcia ? "garcia" : "sneed-folk");
  const auto rank = [&](const std::string& key) {
    return std::find(order.begin(), order.end(), key) - order.begin();
  };
  std::stable_sort(keys.begin(), keys.end(),
                   [&](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
  return keys;
}

std::string group_name(RunGroupKind kind, const std::string& key) {
  switch (kind) {
    case RunGroupKind::kBlock:
      return "block " + key;
    case RunGroupKind::kGarcia:
      return "class " + key;
    case RunGroupKind::kSneedFolk:
      return "sneed-folk " + key;
    case RunGroupKind::kAll:
    case RunGroupKind::kColumn:
      break;
  }
  return "all";
}

void append_file_groups(const std::vector<RunRow>& rows, std::optional<std::uint32_t> file,
                        std::vector<RunGroup>& groups) {
  for (const RunGroupKind kind : {RunGroupKind::kAll, RunGroupKind::kBlock, RunGroupKind::kGarcia,
                                  RunGroupKind::kSneedFolk}) {
    const std::vector<std::string> keys = keys_in_order(rows, kind);
    if (kind == RunGroupKind::kSneedFolk && keys.size() < 2) continue;
    for (const std::string& key : keys) {
      RunGroup group;
      group.name = (file ? "file " + std::to_string(*file + 1) + ": " : "") + group_name(kind, key);
      group.kind = kind;
      group.key = key;
      group.file = file;
      for (std::size_t i = 0; i < rows.size(); ++i) {
        if (file && rows[i].file != *file) continue;
        if (key_of(*rows[i].block, kind) == key) group.rows.push_back(i);
      }
      if (!group.rows.empty()) groups.push_back(std::move(group));
    }
  }
}

DepositStatistics deposits_of(const RunGroup& group, const std::vector<RunRow>& rows) {
  DepositStatistics deposit;
  deposit.started = group.rows.size();
  std::vector<double> along, lateral;
  Vec3 sum = Vec3::Zero();
  for (const std::size_t index : group.rows) {
    const RunRow& row = rows[index];
    switch (row.record->result.stop_reason) {
      case StopReason::kRest:
        ++deposit.stops.rest;
        along.push_back(row.runout);
        lateral.push_back(row.lateral);
        // Summed from the first stop: map coordinates of 5e6 m would cost digits.
        sum += row.stop - rows[group.rows.front()].stop;
        break;
      case StopReason::kLeftTerrain:
        ++deposit.stops.left_terrain;
        break;
      case StopReason::kMaxTime:
        ++deposit.stops.max_time;
        break;
      case StopReason::kError:
        ++deposit.stops.error;
        break;
    }
  }
  deposit.runout = summarise_sample(along);
  deposit.lateral = summarise_sample(lateral);
  if (deposit.stops.rest > 0) {
    deposit.mean_stop =
        rows[group.rows.front()].stop + sum / static_cast<double>(deposit.stops.rest);
  }
  return deposit;
}

}  // namespace

std::vector<const Crossing*> find_counted_crossings(const Comparison& comparison,
                                                    std::size_t line) {
  std::vector<const Crossing*> found(comparison.rows.size(), nullptr);
  for (const BarrierCrossing& crossing : comparison.crossings) {
    if (crossing.counted && crossing.barrier == line) found[crossing.row] = crossing.crossing;
  }
  return found;
}

std::string BarrierLine::direction(const Crossing& crossing) const {
  if (!belongs_to_ring()) return crossing.forward ? "forward" : "backward";
  return crossing.forward == is_counter_clockwise(vertices) ? "out" : "in";
}

std::string BarrierLine::counted_direction() const {
  switch (counts) {
    case Counts::kEither:
      return "either";
    case Counts::kForward:
      return "forward";
    case Counts::kEntries:
      return "in";
    case Counts::kExits:
      return "out";
  }
  return "either";
}

bool BarrierLine::is_in(std::uint32_t file) const {
  return std::find(files.begin(), files.end(), file) != files.end();
}

bool BarrierLine::counted(const Crossing& crossing) const {
  return counts == Counts::kEither || direction(crossing) == counted_direction();
}

std::uint32_t cluster_index_of_run(const CampaignResults& results, const RunRecord& run) {
  return results.persistent_blocks ? run.run / results.persistent_blocks->blocks_per_realisation
                                   : run.point;
}

std::uint32_t RunClustering::of(const RunRow& row) {
  const std::pair key(row.file, cluster_index_of_run(results_[row.file], *row.record));
  const auto [found, added] = numbers_.emplace(key, static_cast<std::uint32_t>(numbers_.size()));
  if (added && results_[row.file].persistent_blocks) ++realisations_;
  return found->second;
}

const std::string& find_release_set(const CampaignResults& results, std::uint32_t point) {
  static const std::string none;
  if (point >= results.set_of_point.size()) return none;
  return results.release_sets[results.set_of_point[point]];
}

void ComparisonOptions::check() const {
  if (margin && !(*margin > 0.0 && std::isfinite(*margin))) {
    throw InputError("margin " + format_significant(*margin, 4) + " m: give a length above 0");
  }
}

Comparison compare(std::vector<CampaignResults> results, const ComparisonOptions& options) {
  options.check();
  check_results(results);
  Comparison comparison;
  comparison.margin = options.margin;
  comparison.results = std::move(results);
  comparison.rows = collect_rows(comparison.results);

  const std::optional<Vec2> asked = asked_downslope(comparison.results);
  const std::optional<Vec2> mean = mean_downslope(comparison.rows);
  comparison.downslope_given = asked.has_value();
  comparison.downslope = asked ? *asked : mean.value_or(Vec2::UnitX());
  for (RunRow& row : comparison.rows) {
    const RunoutMeasures measured = compute_runout(row.start, row.stop, comparison.downslope);
    row.runout = measured.along;
    row.lateral = measured.lateral;
  }
  if (!asked && !mean) {
    const std::string undefined =
        "downslope is undefined: the blocks stopped around their release points; runout and "
        "lateral angle are along +x of the map. Give [run] downslope = [dx, dy] in the campaign";
    comparison.warnings.push_back(undefined);
    comparison.cautions.push_back(
        {"Downslope is undefined, so runout is along +x of the map.", {undefined}});
  }

  append_file_groups(comparison.rows, std::nullopt, comparison.groups);
  for (const std::string& column : options.by) append_column_groups(comparison, column);
  if (comparison.results.size() > 1) {
    for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
      append_file_groups(comparison.rows, file, comparison.groups);
    }
  }
  for (const RunGroup& group : comparison.groups) {
    comparison.deposits.push_back(deposits_of(group, comparison.rows));
  }

  BarrierComparison barriers =
      compare_barriers(comparison.results, comparison.rows, comparison.groups);
  comparison.lines = std::move(barriers.lines);
  comparison.crossings = std::move(barriers.crossings);
  comparison.barriers = std::move(barriers.groups);
  comparison.differences = compute_differences(comparison);
  if (options.measured) {
    comparison.measured = read_measured_stops(*options.measured);
    compare_measured_stops(comparison, *comparison.measured);
  }

  add_comparison_warnings(comparison);
  return comparison;
}

}  // namespace clast
