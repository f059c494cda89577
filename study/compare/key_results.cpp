#include "study/compare/key_results.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/statistics/bootstrap.hpp"
#include "study/compare/detail/comparison_barriers.hpp"
#include "study/compare/ground_draws.hpp"

namespace clast {

using namespace study_detail;
namespace {

constexpr std::uint64_t kAnswerSeed = 20220310;  // any is good; a fixed one repeats the interval
constexpr std::size_t kMaxAnswerDrawn = 20'000'000;  // numbers for one interval
constexpr double kSameStop = 1e-6;                   // m
/// Fraction of the release points or realisations with the same block, as a mean over blocks, from
/// which on the blocks count as equal everywhere.
constexpr double kSameBlocksFraction = 0.25;

using File = std::optional<std::uint32_t>;

/// Groups of one kind, of one file or over all; those without a name left out.
std::vector<std::size_t> groups_in(const Comparison& comparison, RunGroupKind kind,
                                   const File& file) {
  std::vector<std::size_t> found;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const RunGroup& group = comparison.groups[g];
    if (group.kind != kind || group.file != file) continue;
    if (kind != RunGroupKind::kAll && group.key.empty()) continue;
    found.push_back(g);
  }
  return found;
}

/// Each class has files of its own, as where compact and elongated blocks were simulated apart.
bool are_classes_apart(const Comparison& comparison) {
  const std::size_t classes = groups_in(comparison, RunGroupKind::kGarcia, std::nullopt).size();
  if (classes < 2) return false;
  for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
    if (groups_in(comparison, RunGroupKind::kGarcia, file).size() != 1) return false;
  }
  return true;
}

/// Files whose runs were released at the same places.
bool share_points(const CampaignResults& a, const CampaignResults& b) {
  return std::equal(a.release_points.begin(), a.release_points.end(), b.release_points.begin(),
                    b.release_points.end(), [](const Vec3& x, const Vec3& y) {
                      return (x - y).head<2>().norm() < kSameStop;
                    });
}

bool has_single_realisation(const Comparison& comparison, const std::vector<std::size_t>& rows) {
  RunClustering clusters(comparison.results);
  for (const std::size_t row : rows) clusters.of(comparison.rows[row]);
  return clusters.has_single_realisation();
}

/// Mean runout of the runs at rest; none where none is.
std::optional<double> mean_at_rest(const Comparison& comparison,
                                   const std::vector<std::size_t>& rows) {
  std::vector<double> runouts;
  for (const std::size_t row : rows) {
    const RunRow& run = comparison.rows[row];
    if (run.record->result.stop_reason == StopReason::kRest) runouts.push_back(run.runout);
  }
  if (runouts.empty()) return std::nullopt;
  return summarise_sample(runouts).mean;
}

std::optional<Interval> range_of_draws(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  return compute_range_over_draws(std::move(values));
}

RunoutEstimate runout_of(const Comparison& comparison, std::size_t group) {
  RunoutEstimate found;
  found.group = group;
  const DepositStatistics& deposit = comparison.deposits[group];
  found.started = deposit.started;
  found.at_rest = deposit.stops.rest;
  found.mean = deposit.runout.mean;
  found.median = deposit.runout.median;
  found.p95 = deposit.runout.p95;
  found.farthest = deposit.runout.max;
  const std::vector<std::size_t>& rows = comparison.groups[group].rows;
  if (const std::vector<GroundDrawRows> draws = group_rows_by_draw(comparison, rows);
      !draws.empty()) {
    std::vector<double> means;
    for (const GroundDrawRows& draw : draws) {
      if (const auto mean = mean_at_rest(comparison, draw.rows)) means.push_back(*mean);
    }
    found.interval = range_of_draws(std::move(means));
    return found;
  }
  if (has_single_realisation(comparison, rows)) return found;
  RunClustering clusters(comparison.results);
  ClusteredValues values;
  for (const std::size_t row : rows) {
    const RunRow& run = comparison.rows[row];
    if (run.record->result.stop_reason != StopReason::kRest) continue;
    values.values.push_back(run.runout);
    values.clusters.push_back(clusters.of(run));
  }
  if (values.values.size() < 2) return found;
  const std::size_t drawn = clusters.count() > 1 ? clusters.count() : values.values.size();
  found.interval =
      bootstrap_mean_interval(values, clusters.count(), kAnswerSeed,
                              std::clamp<std::size_t>(kMaxAnswerDrawn / drawn, 200, 2000));
  return found;
}

/// Means of the runouts of one group less those of another, in each draw of the ground; draws of
/// two files are independent, so that each of one is set against all of the other.
std::vector<double> gaps_by_draw(const Comparison& comparison, std::size_t first,
                                 std::size_t second) {
  const std::vector<GroundDrawRows> a =
      group_rows_by_draw(comparison, comparison.groups[first].rows);
  const std::vector<GroundDrawRows> b =
      group_rows_by_draw(comparison, comparison.groups[second].rows);
  std::vector<double> gaps;
  for (const GroundDrawRows& of_first : a) {
    const std::optional<double> mean = mean_at_rest(comparison, of_first.rows);
    for (const GroundDrawRows& of_second : b) {
      if (of_first.file == of_second.file && of_first.member != of_second.member) continue;
      const std::optional<double> other = mean_at_rest(comparison, of_second.rows);
      if (mean && other) gaps.push_back(*mean - *other);
    }
  }
  return gaps;
}

RunoutContrast gap_between(const Comparison& comparison, const RunoutEstimate& a,
                           const RunoutEstimate& b,
                           const std::optional<GroupDifference>& difference) {
  const bool ahead = a.mean >= b.mean;
  RunoutContrast gap;
  gap.farther = ahead ? a.group : b.group;
  gap.nearer = ahead ? b.group : a.group;
  gap.mean_difference = std::abs(a.mean - b.mean);
  gap.due_to_few_runs =
      (ahead ? a.median - b.median : b.median - a.median) < kMaxFewRunsRatio * gap.mean_difference;
  if (!a.is_representative() || !b.is_representative() || !difference) return gap;
  gap.verdict = difference->verdict();
  if (gap.verdict == ContrastVerdict::kUntested) return gap;
  if (const auto by_draw = gaps_by_draw(comparison, gap.farther, gap.nearer); !by_draw.empty()) {
    gap.interval = compute_range_over_draws(by_draw);
    if (gap.interval->low < 0.0 && gap.interval->high > 0.0) {
      gap.verdict = ContrastVerdict::kGroundDependent;
    }
    return gap;
  }
  if (difference->interval) {
    const Interval& of = *difference->interval;
    gap.interval = gap.farther == difference->first ? of : Interval{-of.high, -of.low};
  }
  return gap;
}

/// Returns the corrected difference of two classes, or computes it if there is none.
std::optional<GroupDifference> class_difference(const Comparison& comparison, std::size_t a,
                                                std::size_t b) {
  for (const GroupDifference& one : comparison.differences) {
    if (one.first == a && one.second == b && one.quantity == "runout_m") return one;
  }
  return compute_runout_difference(comparison, a, b);
}

/// Returns p95 of the passages, or the largest if they are few.
double limit_of_passages(const SampleSummary& of, bool largest) {
  return largest ? of.max : of.p95;
}

/// Sets the ranges over the draws of the ground.
void add_draw_ranges(const Comparison& comparison, std::size_t line,
                     const std::vector<GroundDrawRows>& draws, CrossingEstimate& share) {
  std::vector<double> shares, energies, speeds, tops;
  for (const BarrierGroupStatistics& of_draw : barrier_groups_by_draw(comparison, line, draws)) {
    shares.push_back(of_draw.probability);
    if (of_draw.crossed == 0) continue;
    energies.push_back(limit_of_passages(of_draw.total, share.largest));
    speeds.push_back(limit_of_passages(of_draw.speed, share.largest));
    tops.push_back(limit_of_passages(of_draw.top, share.largest));
  }
  share.interval = range_of_draws(std::move(shares));
  share.energy_range = range_of_draws(std::move(energies));
  share.speed_range = range_of_draws(std::move(speeds));
  share.top_range = range_of_draws(std::move(tops));
}

CrossingEstimate share_of(const Comparison& comparison, const BarrierGroupStatistics& group) {
  CrossingEstimate share;
  share.group = group.group_index;
  share.started = group.started;
  share.crossed = group.crossed;
  share.passing_probability = group.probability;
  share.interval = group.interval;
  share.largest = group.crossed < kMinPassages;
  share.energy = limit_of_passages(group.total, share.largest);
  share.speed = limit_of_passages(group.speed, share.largest);
  share.height = limit_of_passages(group.height, share.largest);
  share.top = limit_of_passages(group.top, share.largest);
  share.largest_energy = group.total.max;
  share.largest_top = group.top.max;
  const std::vector<GroundDrawRows> draws =
      group_rows_by_draw(comparison, comparison.groups[group.group_index].rows);
  if (!draws.empty()) add_draw_ranges(comparison, group.line, draws, share);
  return share;
}

const BarrierGroupStatistics* barrier_group(const Comparison& comparison, std::size_t line,
                                            std::size_t group) {
  for (const BarrierGroupStatistics& one : comparison.barriers) {
    if (one.line == line && one.group_index == group) return &one;
  }
  return nullptr;
}

/// Returns the mean downslope position of a barrier.
double place_downslope(const Comparison& comparison, std::size_t line) {
  const std::vector<Vec2>& through = comparison.lines[line].vertices;
  Vec2 sum = Vec2::Zero();
  for (const Vec2& point : through) sum += point - through.front();
  return comparison.downslope.dot(through.front() + sum / static_cast<double>(through.size()));
}

std::vector<BarrierSummary> passages_of(const Comparison& comparison,
                                        const FileSummary& statement) {
  std::vector<BarrierSummary> found;
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    if (comparison.lines[line].counts == BarrierLine::Counts::kExits) continue;
    const BarrierGroupStatistics* all = barrier_group(comparison, line, statement.all.group);
    if (all == nullptr) continue;
    BarrierSummary passage;
    passage.line = line;
    passage.all = share_of(comparison, *all);
    for (const RunoutEstimate& one : statement.classes) {
      const BarrierGroupStatistics* group = barrier_group(comparison, line, one.group);
      if (group != nullptr && statement.classes.size() > 1) {
        passage.classes.push_back(share_of(comparison, *group));
      }
    }
    found.push_back(std::move(passage));
  }
  std::stable_sort(
      found.begin(), found.end(), [&](const BarrierSummary& a, const BarrierSummary& b) {
        const bool passed = a.all.crossed > 0, other = b.all.crossed > 0;
        if (passed != other) return passed;
        return place_downslope(comparison, a.line) > place_downslope(comparison, b.line);
      });
  return found;
}

/// True where places or realisations of a file have other blocks each.
bool samples_blocks(const Comparison& comparison, const std::vector<std::size_t>& rows) {
  RunClustering clusters(comparison.results);
  std::map<std::uint32_t, std::set<std::uint32_t>> of_file;
  std::map<std::pair<std::uint32_t, std::string>, std::set<std::uint32_t>> of_block;
  for (const std::size_t row : rows) {
    const RunRow& run = comparison.rows[row];
    const std::uint32_t cluster = clusters.of(run);
    of_file[run.file].insert(cluster);
    of_block[{run.file, run.block->library_block()}].insert(cluster);
  }
  std::size_t met = 0, possible = 0;
  for (const auto& [block, has_block] : of_block) {
    met += has_block.size();
    possible += of_file[block.first].size();
  }
  return static_cast<double>(met) < kSameBlocksFraction * static_cast<double>(possible);
}

FileSummary statement_of(const Comparison& comparison, const File& file) {
  FileSummary statement;
  statement.file = file;
  const std::size_t all = groups_in(comparison, RunGroupKind::kAll, file).front();
  statement.stops = comparison.deposits[all].stops;
  statement.all = runout_of(comparison, all);
  RunClustering clusters(comparison.results);
  for (const std::size_t row : comparison.groups[all].rows) {
    clusters.of(comparison.rows[row]);
    statement.clusters_are_realisations =
        statement.clusters_are_realisations ||
        comparison.results[comparison.rows[row].file].persistent_blocks.has_value();
  }
  statement.clusters = clusters.count();
  for (const std::size_t group : groups_in(comparison, RunGroupKind::kGarcia, file)) {
    statement.classes.push_back(runout_of(comparison, group));
  }
  if (statement.classes.size() > 1) {
    const RunoutEstimate &a = statement.classes[0], &b = statement.classes[1];
    statement.class_contrast =
        gap_between(comparison, a, b, class_difference(comparison, a.group, b.group));
  }
  statement.passages = passages_of(comparison, statement);
  const std::vector<std::size_t>& rows = comparison.groups[all].rows;
  statement.draws = group_rows_by_draw(comparison, rows).size();
  std::set<std::string> blocks;
  for (const std::size_t row : rows) blocks.insert(comparison.rows[row].block->library_block());
  statement.blocks = blocks.size();
  statement.samples_blocks = samples_blocks(comparison, rows);
  return statement;
}

}  // namespace

bool KeyResults::has_draws() const {
  return std::any_of(file_summaries.begin(), file_summaries.end(),
                     [](const FileSummary& statement) { return statement.draws > 0; });
}

KeyResults summarise_key_results(const Comparison& comparison) {
  KeyResults answer;
  const std::size_t files = comparison.results.size();
  if (files == 1 || are_classes_apart(comparison)) {
    answer.file_summaries.push_back(statement_of(comparison, std::nullopt));
    return answer;
  }
  for (std::uint32_t file = 0; file < files; ++file) {
    if (!groups_in(comparison, RunGroupKind::kAll, file).empty()) {
      answer.file_summaries.push_back(statement_of(comparison, file));
    }
  }
  if (answer.file_summaries.size() == 2 &&
      share_points(comparison.results[*answer.file_summaries[0].file],
                   comparison.results[*answer.file_summaries[1].file])) {
    const RunoutEstimate &a = answer.file_summaries[0].all, &b = answer.file_summaries[1].all;
    answer.files =
        gap_between(comparison, a, b, compute_runout_difference(comparison, a.group, b.group));
  }
  return answer;
}

}  // namespace clast
