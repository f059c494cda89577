#include "study/compare/ensemble_effects.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/statistics/statistics.hpp"
#include "study/campaign/ground_fields.hpp"

namespace clast {

namespace {

constexpr std::size_t kMinForIndex = 40, kInBin = 8, kMaxBins = 20;

/// One outcome of each member of an ensemble that has it.
struct Outcome {
  std::string name;
  std::vector<std::uint32_t> members;
  std::vector<double> values;
};

/// The runs of one block group of a file, by member.
struct MemberRuns {
  std::vector<std::size_t> started;
  std::vector<std::vector<double>> runouts;      ///< of the runs at rest, m
  std::vector<std::vector<std::size_t>> passed;  ///< by barrier line, then member
};

const std::string& group_of(const RunRow& row, const CampaignResults& results) {
  return results.ground_sets[row.record->ground_set].group;
}

MemberRuns runs_by_member(const Comparison& comparison, std::uint32_t file,
                          const std::string& group) {
  const CampaignResults& results = comparison.results[file];
  const std::size_t members = count_ensemble_members(results);
  MemberRuns runs{std::vector<std::size_t>(members, 0), std::vector<std::vector<double>>(members),
                  std::vector<std::vector<std::size_t>>(comparison.lines.size(),
                                                        std::vector<std::size_t>(members, 0))};
  const auto is_meant = [&](const RunRow& row) {
    return row.file == file && group_of(row, results) == group;
  };
  const auto member_of = [&](const RunRow& row) {
    return results.ground_sets[row.record->ground_set].member;
  };
  for (const RunRow& row : comparison.rows) {
    if (!is_meant(row)) continue;
    ++runs.started[member_of(row)];
    if (row.record->result.stop_reason == StopReason::kRest) {
      runs.runouts[member_of(row)].push_back(row.runout);
    }
  }
  for (const BarrierCrossing& crossing : comparison.crossings) {
    const RunRow& row = comparison.rows[crossing.row];
    if (crossing.counted && is_meant(row)) ++runs.passed[crossing.barrier][member_of(row)];
  }
  return runs;
}

std::vector<Outcome> outcomes_of(const Comparison& comparison, std::uint32_t file,
                                 const MemberRuns& runs) {
  std::vector<Outcome> outcomes = {{"mean runout", {}, {}}};
  for (std::uint32_t member = 0; member < runs.started.size(); ++member) {
    if (runs.runouts[member].empty()) continue;
    outcomes[0].members.push_back(member);
    outcomes[0].values.push_back(summarise_sample(runs.runouts[member]).mean);
  }
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    if (!comparison.lines[line].is_in(file)) continue;
    Outcome outcome{"past " + comparison.lines[line].name, {}, {}};
    for (std::uint32_t member = 0; member < runs.started.size(); ++member) {
      if (runs.started[member] == 0) continue;
      outcome.members.push_back(member);
      outcome.values.push_back(static_cast<double>(runs.passed[line][member]) /
                               static_cast<double>(runs.started[member]));
    }
    outcomes.push_back(std::move(outcome));
  }
  std::erase_if(outcomes, [](const Outcome& outcome) { return outcome.values.empty(); });
  return outcomes;
}

std::vector<double> ascending(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values;
}

void add_effects(const Comparison& comparison, std::uint32_t file, const std::string& group,
                 std::vector<ParameterEffect>& effects) {
  const CampaignResults& results = comparison.results[file];
  std::vector<const GroundParameterSet*> set_of(count_ensemble_members(results), nullptr);
  for (const GroundParameterSet& set : results.ground_sets) {
    if (set.group == group) set_of[set.member] = &set;
  }
  for (const Outcome& outcome :
       outcomes_of(comparison, file, runs_by_member(comparison, file, group))) {
    const std::vector<double> ordered = ascending(outcome.values);
    for (std::size_t zone = 0; zone < results.zone_names.size(); ++zone) {
      for (const GroundParameterField& field : ground_parameter_fields()) {
        std::vector<double> drawn;
        for (const std::uint32_t member : outcome.members) {
          drawn.push_back(set_of[member]->zones[zone].*field.value);
        }
        const std::vector<double> values = ascending(drawn);
        if (values.front() == values.back()) continue;
        effects.push_back({file, group, results.zone_names[zone], field.name, drawn.size(),
                           values.front(), quantile(values, 0.5), values.back(), outcome.name,
                           quantile(ordered, 0.05), quantile(ordered, 0.5), quantile(ordered, 0.95),
                           spearman_test(drawn, outcome.values),
                           estimate_first_order_index(drawn, outcome.values)});
      }
    }
  }
}

}  // namespace

std::uint32_t count_ensemble_members(const CampaignResults& results) {
  std::uint32_t members = 1;
  for (const GroundParameterSet& set : results.ground_sets)
    members = std::max(members, set.member + 1);
  return members;
}

std::optional<double> estimate_first_order_index(std::span<const double> x,
                                                 std::span<const double> y) {
  const std::size_t count = x.size();
  if (count < kMinForIndex) return std::nullopt;
  const auto equal = [](std::span<const double> values) {
    return std::all_of(values.begin(), values.end(),
                       [&](double value) { return value == values.front(); });
  };
  if (equal(x) || equal(y)) return std::nullopt;
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
  const std::size_t groups = std::min(kMaxBins, count / kInBin);
  const double mean = summarise_sample(y).mean;
  double between = 0.0, within = 0.0;
  for (std::size_t group = 0; group < groups; ++group) {
    std::vector<double> values;
    for (std::size_t i = group * count / groups; i < (group + 1) * count / groups; ++i) {
      values.push_back(y[order[i]]);
    }
    const double own = summarise_sample(values).mean;
    between += static_cast<double>(values.size()) * (own - mean) * (own - mean);
    for (const double value : values) within += (value - own) * (value - own);
  }
  // Hays' omega squared: the means of groups differ by chance too.
  const double chance = within / static_cast<double>(count - groups);
  const double share =
      (between - static_cast<double>(groups - 1) * chance) / (between + within + chance);
  return std::clamp(share, 0.0, 1.0);
}

std::vector<ParameterEffect> compute_ensemble_effects(const Comparison& comparison) {
  std::vector<ParameterEffect> effects;
  for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    if (count_ensemble_members(results) < 2) continue;
    std::vector<std::string> groups;
    for (const GroundParameterSet& set : results.ground_sets) {
      if (std::find(groups.begin(), groups.end(), set.group) == groups.end()) {
        groups.push_back(set.group);
      }
    }
    for (const std::string& group : groups) add_effects(comparison, file, group, effects);
  }
  return effects;
}

}  // namespace clast
