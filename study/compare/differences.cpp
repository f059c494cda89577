#include "study/compare/differences.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "core/angle.hpp"
#include "core/number_text.hpp"
#include "core/statistics/clustered_test.hpp"
#include "study/compare/comparison.hpp"

namespace clast {
namespace {

constexpr std::size_t kFewest = 3;  ///< values of a group
constexpr int kMostDecimals = 4;
/// Any seed is good; a fixed one gives the same interval every time.
constexpr std::uint64_t kDifferenceSeed = 20220310;

constexpr std::size_t kMostDifferenceDrawn = 20'000'000;  ///< numbers for one interval or test

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
    std::vector<const Crossing*> first(comparison.rows.size(), nullptr);
    for (const CrossingRow& crossing : comparison.crossings) {
      if (crossing.counted && crossing.barrier == line) first[crossing.row] = crossing.crossing;
    }
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

GroupSample sample_of(const Comparison& comparison, const Group& group,
                      const ComparedQuantity& quantity, RunClusters& clusters) {
  GroupSample sample;
  RunClusters own(comparison.results);
  for (const std::size_t row : group.rows) {
    const std::optional<double> value = quantity.value(row);
    if (!value || !std::isfinite(*value)) continue;
    sample.values.values.push_back(*value);
    sample.values.clusters.push_back(clusters.of(comparison.rows[row]));
    own.of(comparison.rows[row]);
  }
  sample.one_realisation = own.is_one_realisation();
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

std::optional<Difference> difference_between(const Comparison& comparison, std::size_t first,
                                             std::size_t second, const ComparedQuantity& quantity) {
  RunClusters clusters(comparison.results);
  const GroupSample first_sample =
      sample_of(comparison, comparison.groups[first], quantity, clusters);
  const GroupSample second_sample =
      sample_of(comparison, comparison.groups[second], quantity, clusters);
  const ClusteredValues &a = first_sample.values, &b = second_sample.values;
  if (a.values.size() < kFewest || b.values.size() < kFewest) return std::nullopt;
  Difference found;
  found.first = first;
  found.second = second;
  found.quantity = quantity.name;
  found.first_runs = a.values.size();
  found.second_runs = b.values.size();
  found.points = clusters.count();
  found.first_mean = summarise(a.values).mean;
  found.second_mean = summarise(b.values).mean;
  found.cliffs_delta = *cliffs_delta(a.values, b.values);
  found.hedges_g = hedges_g(a.values, b.values);
  if (first_sample.one_realisation || second_sample.one_realisation) {
    found.ks_distance = two_sample_ks(a.values, b.values)->statistic;
    return found;
  }
  found.by_runs = are_points_alone(a, b);
  const std::size_t runs = a.values.size() + b.values.size();
  const std::size_t drawn_from = found.by_runs ? 1 : clusters.count();
  // Large samples are drawn less often.
  const auto draws = [&](std::size_t numbers, std::size_t most) {
    return std::clamp<std::size_t>(kMostDifferenceDrawn / numbers, 200, most);
  };
  found.interval = bootstrap_difference(a, b, drawn_from, kDifferenceSeed,
                                        draws(found.by_runs ? runs : clusters.count(), 2000));
  const TestResult test = *clustered_ks(a, b, drawn_from, kDifferenceSeed, draws(runs, 9999));
  found.ks_distance = test.statistic;
  found.p_value = test.p_value;
  return found;
}

/// Corrects the p-values of a family for all of its tests.
void correct_family(std::vector<Difference>& family) {
  std::vector<double> p_values;
  for (const Difference& one : family) {
    if (one.p_value) p_values.push_back(*one.p_value);
  }
  const std::vector<double> corrected = holm(p_values);
  std::size_t next = 0;
  for (Difference& one : family) {
    if (!one.p_value) continue;
    one.p_holm = corrected[next++];
    one.tests = corrected.size();
  }
}

// Groups over all files, of every kind but "all"; those of one column are a kind.
std::map<std::pair<GroupKind, std::string>, std::vector<std::size_t>> families(
    const Comparison& comparison) {
  std::map<std::pair<GroupKind, std::string>, std::vector<std::size_t>> kinds;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const Group& group = comparison.groups[g];
    if (group.kind == GroupKind::kAll || group.file) continue;
    kinds[{group.kind, group.column}].push_back(g);
  }
  return kinds;
}

}  // namespace

std::vector<Difference> differences(const Comparison& comparison) {
  const std::vector<ComparedQuantity> all = quantities(comparison);
  std::vector<Difference> found;
  for (const auto& [kind, groups] : families(comparison)) {
    if (groups.size() > kMostGroups) continue;
    std::vector<Difference> family;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      for (std::size_t k = i + 1; k < groups.size(); ++k) {
        for (const ComparedQuantity& quantity : all) {
          if (std::optional<Difference> one =
                  difference_between(comparison, groups[i], groups[k], quantity)) {
            family.push_back(std::move(*one));
          }
        }
      }
    }
    correct_family(family);
    for (Difference& one : family) found.push_back(std::move(one));
  }
  return found;
}

std::optional<Difference> runout_difference(const Comparison& comparison, std::size_t first,
                                            std::size_t second) {
  std::optional<Difference> found =
      difference_between(comparison, first, second, quantities(comparison).front());
  if (found && found->p_value) {
    found->p_holm = found->p_value;
    found->tests = 1;
  }
  return found;
}

Evidence evidence_of(const Difference& difference) {
  if (!difference.p_holm) return Evidence::kOneRealisation;
  if (!difference.found()) return Evidence::kCanBeChance;
  return difference.interval_excludes_zero() ? Evidence::kMoreThanChance : Evidence::kOtherSpread;
}

QuantityWords words_of_quantity(const std::string& quantity) {
  const std::size_t blank = quantity.rfind(' ');
  const std::string barrier = blank == quantity.npos ? "" : " at " + quantity.substr(0, blank);
  const std::string name = blank == quantity.npos ? quantity : quantity.substr(blank + 1);
  if (name == "runout_m") return {"runout", "m"};
  if (name == "lateral_deg") return {"lateral angle", "deg"};
  if (name == "path_length_m") return {"path length", "m"};
  if (name == "max_speed_m_s") return {"largest speed", "m/s"};
  if (name == "speed_m_s") return {"speed" + barrier, "m/s"};
  if (name == "total_energy_j") return {"energy" + barrier, "kJ", 1e-3};
  if (name == "height_m") return {"height" + barrier, "m"};
  return {quantity, ""};
}

std::string gap_in_words(double gap, const std::optional<Interval>& interval,
                         const std::string& unit) {
  const double sign = gap < 0.0 ? -1.0 : 1.0;
  const std::string way = gap < 0.0 ? " less" : " more";
  const std::string of_unit = unit.empty() ? "" : " " + unit;
  if (!interval) return with_digits(sign * gap, 3) + of_unit + way;
  double low = sign * interval->low;
  double high = sign * interval->high;
  if (low > high) std::swap(low, high);
  const int decimals = decimals_known({low, high}, kMostDecimals);
  return with_decimals(sign * gap, decimals) + of_unit + way + " (" + with_decimals(low, decimals) +
         " to " + with_decimals(high, decimals) + of_unit + ")";
}

std::string gap_in_words(const Difference& difference) {
  const QuantityWords words = words_of_quantity(difference.quantity);
  std::optional<Interval> interval = difference.interval;
  if (interval) interval = {words.factor * interval->low, words.factor * interval->high};
  return gap_in_words(words.factor * (difference.first_mean - difference.second_mean), interval,
                      words.unit);
}

std::string in_words(const Difference& difference, const Comparison& comparison) {
  const QuantityWords words = words_of_quantity(difference.quantity);
  const auto mean = [&](double value) {
    return with_digits(words.factor * value, 3) + " " + words.unit;
  };
  const std::string means = words.name + ": " + comparison.groups[difference.first].name + " " +
                            mean(difference.first_mean) + " on average, " +
                            comparison.groups[difference.second].name + " " +
                            mean(difference.second_mean) + "; " + gap_in_words(difference);
  switch (evidence_of(difference)) {
    case Evidence::kOneRealisation:
      return means + "; one realisation does not show whether this is chance";
    case Evidence::kMoreThanChance:
      return means;
    case Evidence::kOtherSpread:
      return means + ", which can be chance, but the values are spread differently";
    case Evidence::kCanBeChance:
      break;
  }
  return means + ", which can be chance" +
         (difference.tests > 1 ? " among " + std::to_string(difference.tests) + " differences"
                               : "");
}

}  // namespace clast
