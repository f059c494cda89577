#include "study/compare/differences.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "core/angle.hpp"
#include "core/statistics/bootstrap.hpp"
#include "core/statistics/clustered_test.hpp"
#include "core/statistics/effect_sizes.hpp"
#include "study/compare/comparison.hpp"

namespace clast {
namespace {

constexpr std::size_t kFewest = 3;  ///< values of a group
/// Any seed is good; a fixed one gives the same interval every time.
constexpr std::uint64_t kDifferenceSeed = 20220310;

constexpr std::size_t kMaxDifferenceDrawn = 20'000'000;  ///< numbers for one interval or test

struct ComparedQuantity {
  std::string name;
  std::function<std::optional<double>(std::size_t row)> value;
};

std::vector<ComparedQuantity> quantities(const Comparison& comparison) {
  const auto of_row = [&](std::string name, StopReason only, double (*value)(const RunRow&)) {
    return ComparedQuantity{std::move(name), [&comparison, only, value](std::size_t index) {
                              const RunRow& row = comparison.rows[index];
                              const StopReason reason = row.record->result.stop_reason;
                              const bool counts = only == StopReason::kRest
                                                      ? reason == only
                                                      : reason != StopReason::kError;
                              return counts ? std::optional<double>(value(row)) : std::nullopt;
                            }};
  };
  std::vector<ComparedQuantity> all = {
      of_row("runout_m", StopReason::kRest, [](const RunRow& row) { return row.runout; }),
      of_row("lateral_deg", StopReason::kRest,
             [](const RunRow& row) { return row.lateral * kDegreesPerRadian; }),
      of_row("path_length_m", StopReason::kRest,
             [](const RunRow& row) { return row.record->result.path_length; }),
      of_row("max_speed_m_s", StopReason::kError,
             [](const RunRow& row) { return row.record->result.max_speed; })};
  for (std::size_t line = 0; line < comparison.lines.size(); ++line) {
    const std::vector<const Crossing*> first = find_counted_crossings(comparison, line);
    const auto at_line = [&](const char* name, double (*value)(const Crossing&)) {
      all.push_back({comparison.lines[line].name + " " + name,
                     [first, value](std::size_t row) -> std::optional<double> {
                       if (first[row] == nullptr) return std::nullopt;
                       return value(*first[row]);
                     }});
    };
    at_line("speed_m_s", [](const Crossing& c) { return c.velocity.norm(); });
    at_line("total_energy_j",
            [](const Crossing& c) { return c.translational_energy + c.rotational_energy; });
    at_line("height_m", [](const Crossing& c) { return c.height; });
  }
  return all;
}

/// Values of a group, and whether they are of one realisation.
struct GroupSample {
  ClusteredValues values;
  bool one_realisation = false;
};

GroupSample sample_of(const Comparison& comparison, const RunGroup& group,
                      const ComparedQuantity& quantity, RunClustering& clusters) {
  GroupSample sample;
  RunClustering own(comparison.results);
  for (const std::size_t row : group.rows) {
    const std::optional<double> value = quantity.value(row);
    if (!value || !std::isfinite(*value)) continue;
    sample.values.values.push_back(*value);
    sample.values.clusters.push_back(clusters.of(comparison.rows[row]));
    own.of(comparison.rows[row]);
  }
  sample.one_realisation = own.has_single_realisation();
  return sample;
}

/// One release point, or one of its own for each group: points say nothing then about how much they
/// scatter, and runs are all there is to draw.
bool are_points_alone(const ClusteredValues& a, const ClusteredValues& b) {
  const auto all_of_first = [](const std::vector<std::uint32_t>& clusters) {
    return std::all_of(clusters.begin(), clusters.end(),
                       [&](std::uint32_t cluster) { return cluster == clusters.front(); });
  };
  return all_of_first(a.clusters) && all_of_first(b.clusters);
}

std::optional<GroupDifference> difference_between(const Comparison& comparison, std::size_t first,
                                                  std::size_t second,
                                                  const ComparedQuantity& quantity) {
  RunClustering clusters(comparison.results);
  const GroupSample first_sample =
      sample_of(comparison, comparison.groups[first], quantity, clusters);
  const GroupSample second_sample =
      sample_of(comparison, comparison.groups[second], quantity, clusters);
  const ClusteredValues &a = first_sample.values, &b = second_sample.values;
  if (a.values.size() < kFewest || b.values.size() < kFewest) return std::nullopt;
  GroupDifference found;
  found.first = first;
  found.second = second;
  found.quantity = quantity.name;
  found.first_runs = a.values.size();
  found.second_runs = b.values.size();
  found.points = clusters.count();
  found.first_mean = summarise_sample(a.values).mean;
  found.second_mean = summarise_sample(b.values).mean;
  found.estimate = found.first_mean - found.second_mean;
  found.cliffs_delta = *cliffs_delta(a.values, b.values);
  found.hedges_g = hedges_g(a.values, b.values);
  if (first_sample.one_realisation || second_sample.one_realisation) {
    found.ks_distance = two_sample_ks_test(a.values, b.values)->statistic;
    return found;
  }
  const bool by_runs = are_points_alone(a, b);
  const std::size_t runs = a.values.size() + b.values.size();
  const std::size_t drawn_from = by_runs ? 1 : clusters.count();
  // Large samples are drawn less often.
  const auto draws = [&](std::size_t numbers, std::size_t maximum) {
    return std::clamp<std::size_t>(kMaxDifferenceDrawn / numbers, 200, maximum);
  };
  found.interval = bootstrap_difference_interval(a, b, drawn_from, kDifferenceSeed,
                                                 draws(by_runs ? runs : clusters.count(), 2000));
  const TestResult test = *clustered_ks_test(a, b, drawn_from, kDifferenceSeed, draws(runs, 9999));
  found.ks_distance = test.statistic;
  found.p_value = test.p_value;
  return found;
}

// Groups over all files, of every kind but "all"; those of one column are a kind.
std::map<std::pair<RunGroupKind, std::string>, std::vector<std::size_t>> families(
    const Comparison& comparison) {
  std::map<std::pair<RunGroupKind, std::string>, std::vector<std::size_t>> kinds;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const RunGroup& group = comparison.groups[g];
    if (group.kind == RunGroupKind::kAll || group.file) continue;
    kinds[{group.kind, group.column}].push_back(g);
  }
  return kinds;
}

}  // namespace

std::vector<GroupDifference> compute_differences(const Comparison& comparison) {
  const std::vector<ComparedQuantity> all = quantities(comparison);
  std::vector<GroupDifference> found;
  for (const auto& [kind, groups] : families(comparison)) {
    if (groups.size() > kMaxComparedGroups) continue;
    std::vector<GroupDifference> family;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      for (std::size_t k = i + 1; k < groups.size(); ++k) {
        for (const ComparedQuantity& quantity : all) {
          if (std::optional<GroupDifference> one =
                  difference_between(comparison, groups[i], groups[k], quantity)) {
            family.push_back(std::move(*one));
          }
        }
      }
    }
    correct_multiple_tests(family);
    for (GroupDifference& one : family) found.push_back(std::move(one));
  }
  return found;
}

std::optional<GroupDifference> compute_runout_difference(const Comparison& comparison,
                                                         std::size_t first, std::size_t second) {
  std::optional<GroupDifference> found =
      difference_between(comparison, first, second, quantities(comparison).front());
  if (found && found->p_value) {
    found->holm_p_value = found->p_value;
    found->family_size = 1;
  }
  return found;
}

}  // namespace clast
