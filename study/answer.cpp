#include "study/answer.hpp"

#include <algorithm>
#include <set>

#include "study/ensemble_effects.hpp"

namespace clast {
namespace {

constexpr std::uint64_t kAnswerSeed = 20220310;  // any is good; a fixed one repeats the interval
constexpr std::size_t kMostAnswerDrawn = 20'000'000;  // numbers for one interval
constexpr double kSameStop = 1e-6;                    // m
constexpr std::size_t kFewestClustersToDraw = 2;

using File = std::optional<std::uint32_t>;

/// Groups of one kind, of one file or over all; those without a name left out.
std::vector<std::size_t> groups_in(const Comparison& comparison, GroupKind kind, const File& file) {
  std::vector<std::size_t> found;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const Group& group = comparison.groups[g];
    if (group.kind != kind || group.file != file) continue;
    if (kind != GroupKind::kAll && group.key.empty()) continue;
    found.push_back(g);
  }
  return found;
}

/// Each class has files of its own, as where compact and elongated blocks were simulated apart.
bool are_classes_apart(const Comparison& comparison) {
  const std::size_t classes = groups_in(comparison, GroupKind::kGarcia, std::nullopt).size();
  if (classes < 2) return false;
  for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
    if (groups_in(comparison, GroupKind::kGarcia, file).size() != 1) return false;
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

/// Are the runs of a group of one realisation, whose blocks depend on each other?
bool is_one_realisation(const Comparison& comparison, const std::vector<std::size_t>& rows) {
  RunClusters clusters(comparison.results);
  bool any = false;
  for (const std::size_t row : rows) {
    any = any || comparison.results[comparison.rows[row].file].stay.has_value();
    clusters.of(comparison.rows[row]);
  }
  return any && clusters.count() < kFewestClustersToDraw;
}

RunoutAnswer runout_of(const Comparison& comparison, std::size_t group) {
  RunoutAnswer found;
  found.group = group;
  const DepositGroup& deposit = comparison.deposits[group];
  found.started = deposit.started;
  found.at_rest = deposit.stops.rest;
  found.mean = deposit.runout.mean;
  found.median = deposit.runout.median;
  found.p95 = deposit.runout.p95;
  found.farthest = deposit.runout.max;
  const std::vector<std::size_t>& rows = comparison.groups[group].rows;
  if (is_one_realisation(comparison, rows)) return found;
  RunClusters clusters(comparison.results);
  ClusteredValues values;
  for (const std::size_t row : rows) {
    const RunRow& run = comparison.rows[row];
    if (run.record->result.stop_reason != StopReason::kRest) continue;
    values.values.push_back(run.runout);
    values.clusters.push_back(clusters.of(run));
  }
  if (values.values.size() < 2) return found;
  const std::size_t drawn = clusters.count() > 1 ? clusters.count() : values.values.size();
  found.interval = bootstrap_mean(values, clusters.count(), kAnswerSeed,
                                  std::clamp<std::size_t>(kMostAnswerDrawn / drawn, 200, 2000));
  return found;
}

Standing standing_of(const Difference& difference) {
  switch (evidence_of(difference)) {
    case Evidence::kMoreThanChance:
      return Standing::kMoreThanChance;
    case Evidence::kOtherSpread:
      return Standing::kOtherSpread;
    case Evidence::kCanBeChance:
      break;
  }
  return Standing::kCanBeChance;
}

GapAnswer gap_between(const Comparison& comparison, const RunoutAnswer& a, const RunoutAnswer& b,
                      const std::optional<Difference>& difference) {
  const bool ahead = a.mean >= b.mean;
  GapAnswer gap;
  gap.farther = ahead ? a.group : b.group;
  gap.nearer = ahead ? b.group : a.group;
  gap.gap = std::abs(a.mean - b.mean);
  gap.of_few = (ahead ? a.median - b.median : b.median - a.median) < kGapOfFew * gap.gap;
  if (!a.stands() || !b.stands() || !difference) return gap;
  std::vector<std::size_t> rows = comparison.groups[a.group].rows;
  const std::vector<std::size_t>& others = comparison.groups[b.group].rows;
  rows.insert(rows.end(), others.begin(), others.end());
  if (is_one_realisation(comparison, rows) ||
      (is_one_realisation(comparison, comparison.groups[a.group].rows) &&
       is_one_realisation(comparison, others))) {
    gap.standing = Standing::kOneRealisation;
    return gap;
  }
  gap.standing = standing_of(*difference);
  if (difference->interval) {
    const Interval& of = *difference->interval;
    gap.interval = gap.farther == difference->first ? of : Interval{-of.high, -of.low};
  }
  return gap;
}

/// Of the two classes; with one file, or one for all, it is among the differences, corrected.
std::optional<Difference> class_difference(const Comparison& comparison, std::size_t a,
                                           std::size_t b) {
  for (const Difference& one : comparison.differences) {
    if (one.first == a && one.second == b && one.quantity == "runout_m") return one;
  }
  return runout_difference(comparison, a, b);
}

ShareAnswer share_of(const Comparison& comparison, const BarrierGroup& group) {
  ShareAnswer share{group.group_index, group.started, group.crossed, group.probability, {}};
  share.largest = group.crossed < kFewestPassages;
  const auto below = [&](const Summary& of) { return share.largest ? of.max : of.p95; };
  share.energy = below(group.total);
  share.speed = below(group.speed);
  share.height = below(group.height);
  share.top = below(group.top);
  share.largest_energy = group.total.max;
  share.largest_top = group.top.max;
  if (!is_one_realisation(comparison, comparison.groups[group.group_index].rows)) {
    share.interval = group.interval;
  }
  return share;
}

const BarrierGroup* barrier_group(const Comparison& comparison, std::size_t line,
                                  std::size_t group) {
  for (const BarrierGroup& one : comparison.barriers) {
    if (one.line == line && one.group_index == group) return &one;
  }
  return nullptr;
}

/// How far down a barrier lies.
double place_downslope(const Comparison& comparison, std::size_t line) {
  const std::vector<Vec2>& through = comparison.lines[line].through;
  Vec2 sum = Vec2::Zero();
  for (const Vec2& point : through) sum += point - through.front();
  return comparison.downslope.dot(through.front() + sum / static_cast<double>(through.size()));
}

std::vector<PassageAnswer> passages_of(const Comparison& comparison, const Statement& statement) {
  std::vector<PassageAnswer> found;
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    if (comparison.lines[line].counts == BarrierLine::Counts::kExits) continue;
    const BarrierGroup* all = barrier_group(comparison, line, statement.all.group);
    if (all == nullptr) continue;
    PassageAnswer passage;
    passage.line = line;
    passage.all = share_of(comparison, *all);
    for (const RunoutAnswer& one : statement.classes) {
      const BarrierGroup* group = barrier_group(comparison, line, one.group);
      if (group != nullptr && statement.classes.size() > 1) {
        passage.classes.push_back(share_of(comparison, *group));
      }
    }
    found.push_back(std::move(passage));
  }
  std::stable_sort(found.begin(), found.end(), [&](const PassageAnswer& a, const PassageAnswer& b) {
    const bool passed = a.all.crossed > 0, other = b.all.crossed > 0;
    if (passed != other) return passed;
    return place_downslope(comparison, a.line) > place_downslope(comparison, b.line);
  });
  return found;
}

std::vector<GroundBand> ground_of(const Comparison& comparison, const File& file) {
  std::vector<GroundBand> bands;
  if (comparison.results.size() > 1 && !file) return bands;
  for (const ParameterEffect& effect : ensemble_effects(comparison)) {
    if (effect.file != file.value_or(0) || !effect.group.empty()) continue;
    const bool known = std::any_of(bands.begin(), bands.end(), [&](const GroundBand& band) {
      return band.outcome == effect.outcome;
    });
    if (known) continue;
    bands.push_back({effect.outcome, effect.members, effect.outcome_p5, effect.outcome_p95});
  }
  return bands;
}

Statement statement_of(const Comparison& comparison, const File& file) {
  Statement statement;
  statement.file = file;
  const std::size_t all = groups_in(comparison, GroupKind::kAll, file).front();
  statement.stops = comparison.deposits[all].stops;
  statement.all = runout_of(comparison, all);
  RunClusters clusters(comparison.results);
  for (const std::size_t row : comparison.groups[all].rows) {
    clusters.of(comparison.rows[row]);
    statement.of_realisations =
        statement.of_realisations || comparison.results[comparison.rows[row].file].stay.has_value();
  }
  statement.clusters = clusters.count();
  for (const std::size_t group : groups_in(comparison, GroupKind::kGarcia, file)) {
    statement.classes.push_back(runout_of(comparison, group));
  }
  if (statement.classes.size() > 1) {
    const RunoutAnswer &a = statement.classes[0], &b = statement.classes[1];
    statement.gap = gap_between(comparison, a, b, class_difference(comparison, a.group, b.group));
  }
  statement.passages = passages_of(comparison, statement);
  statement.ground = ground_of(comparison, file);
  return statement;
}

}  // namespace

Answer answer(const Comparison& comparison) {
  Answer answer;
  const std::size_t files = comparison.results.size();
  if (files == 1 || are_classes_apart(comparison)) {
    answer.statements.push_back(statement_of(comparison, std::nullopt));
    return answer;
  }
  for (std::uint32_t file = 0; file < files; ++file) {
    if (!groups_in(comparison, GroupKind::kAll, file).empty()) {
      answer.statements.push_back(statement_of(comparison, file));
    }
  }
  if (answer.statements.size() == 2 &&
      share_points(comparison.results[*answer.statements[0].file],
                   comparison.results[*answer.statements[1].file])) {
    const RunoutAnswer &a = answer.statements[0].all, &b = answer.statements[1].all;
    answer.files = gap_between(comparison, a, b, runout_difference(comparison, a.group, b.group));
  }
  return answer;
}

}  // namespace clast
