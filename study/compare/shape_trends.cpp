#include "study/compare/shape_trends.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "classify/surface_indices.hpp"
#include "core/error.hpp"
#include "core/statistics/clustered_trend.hpp"
#include "core/statistics/contrast.hpp"
#include "study/campaign/planned_power.hpp"
#include "study/compare/detail/run_outcomes.hpp"

namespace clast {

using namespace study_detail;
namespace {

constexpr double kSameProperty = 0.01;  ///< absolute of ratios, relative of masses
constexpr std::uint64_t kTrendSeed = 20;

/// A property of blocks; not a number where a block has none.
struct ShapeProperty {
  std::string name;
  std::function<double(const BlockSummary&)> of;
  double least_range = kSameProperty;
};

double convexity_of(const CampaignResults& results, const BlockSummary& block) {
  const SpheroPolyhedron& shape = results.shapes[block.shape];
  if (shape.faces.empty()) return 1.0;  // a ball or a capsule
  return convexity(shape, block.volume / std::pow(block.scale, 3.0));
}

std::vector<ShapeProperty> properties_of(const CampaignResults& results) {
  std::vector<ShapeProperty> properties = {
      {"I/L", [](const BlockSummary& block) { return block.axes.I / block.axes.L; }},
      {"S/L", [](const BlockSummary& block) { return block.axes.S / block.axes.L; }}};
  const bool shapes =
      std::all_of(results.blocks.begin(), results.blocks.end(), [&](const BlockSummary& block) {
        return block.shape < results.shapes.size() && block.volume > 0.0;
      });
  if (shapes) {
    properties.push_back({"convexity", [&results](const BlockSummary& block) {
                            return convexity_of(results, block);
                          }});
    properties.push_back({"rounding", [&results](const BlockSummary& block) {
                            return results.shapes[block.shape].radius * block.scale / block.axes.S;
                          }});
  }
  properties.push_back({"mass", [](const BlockSummary& block) { return block.mass; }, 0.0});
  return properties;
}

/// Numbers for keys, in the order they are met.
template <class Key>
class Numbers {
 public:
  std::uint32_t of(const Key& key) {
    return numbers_.try_emplace(key, static_cast<std::uint32_t>(numbers_.size())).first->second;
  }

 private:
  std::map<Key, std::uint32_t> numbers_;
};

/// Runs of a file, and how they belong together by one property.
struct Grouping {
  TrendSample trend;     ///< values still to be set
  CrossedSample halves;  ///< values still to be set
  double limit = 0.0;    ///< first of the upper half
};

/// True if every library block occurs with several masses.
bool has_crossed_masses(const std::vector<const RunRow*>& rows) {
  const std::vector<double> masses = find_distinct_masses(rows);
  std::map<std::string, std::set<std::size_t>> of_form;
  for (const RunRow* row : rows) {
    of_form[row->block->library_block()].insert(find_mass_level(masses, row->block->mass));
  }
  return std::all_of(of_form.begin(), of_form.end(),
                     [](const auto& form) { return form.second.size() > 1; });
}

/// Returns the start of the upper half of the units; never between equal values.
double limit_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const auto above = std::upper_bound(values.begin(), values.end(), values[half]);
  const auto from = std::lower_bound(values.begin(), values.end(), values[half]);
  const std::size_t before = half - static_cast<std::size_t>(from - values.begin());
  const std::size_t after = static_cast<std::size_t>(above - values.begin()) - half;
  const bool up = above != values.end() && (from == values.begin() || after < before);
  return up ? *above : values[half];
}

Grouping grouping_by(const ShapeProperty& property, const std::vector<const RunRow*>& rows,
                     bool crossed_masses) {
  const bool of_mass = property.name == "mass";
  const bool of_blocks = of_mass || !crossed_masses;
  Grouping grouping;
  Numbers<std::string> units, forms;
  Numbers<std::pair<std::uint32_t, std::uint32_t>> strata;
  const std::vector<double> masses = find_distinct_masses(rows);
  for (const RunRow* row : rows) {
    const std::uint32_t form = forms.of(row->block->library_block());
    const std::uint32_t unit = units.of(of_blocks ? row->block->id : row->block->library_block());
    const auto mass = static_cast<std::uint32_t>(find_mass_level(masses, row->block->mass));
    if (unit == grouping.trend.property.size()) {
      grouping.trend.property.push_back(property.of(*row->block));
      grouping.trend.strata.push_back(of_mass && crossed_masses ? form : 0);
    }
    // Values are compared within a point, and where masses are crossed also within mass or form.
    const std::uint32_t other = !crossed_masses ? 0 : of_mass ? form : mass;
    grouping.trend.units.push_back(unit);
    grouping.halves.units.push_back(of_mass && crossed_masses ? form : unit);
    grouping.halves.points.push_back(row->record->point);
    grouping.halves.strata.push_back(strata.of({row->record->point, other}));
  }
  grouping.trend.clusters = grouping.halves.strata;
  grouping.limit = limit_of(grouping.trend.property);
  for (const std::uint32_t unit : grouping.trend.units) {
    grouping.halves.in_second_group.push_back(grouping.trend.property[unit] >= grouping.limit);
  }
  return grouping;
}

/// True if the property differs between blocks by more than the measurement error.
bool differs(const ShapeProperty& property, const TrendSample& sample) {
  const auto [minimum, maximum] =
      std::minmax_element(sample.property.begin(), sample.property.end());
  const double range =
      property.least_range > 0.0 ? property.least_range : kSameProperty * std::abs(*maximum);
  return *maximum - *minimum >= range;
}

std::optional<ShapeTrend> trend_of(const RunOutcome& outcome, const ShapeProperty& property,
                                   Grouping& grouping, const std::optional<double>& margin) {
  grouping.trend.values = outcome.values;
  grouping.halves.values = outcome.values;
  const std::optional<TestResult> trend = clustered_trend_test(grouping.trend, kTrendSeed);
  const std::optional<CrossedDifference> halves = crossed_difference(grouping.halves);
  if (!trend || !halves) return std::nullopt;
  ShapeTrend found;
  found.outcome = outcome.name;
  found.unit = outcome.unit;
  found.property = property.name;
  found.blocks = grouping.trend.property.size();
  found.runs = outcome.values.size();
  found.trend = *trend;
  found.limit = grouping.limit;
  found.halves = *halves;
  found.detectable_difference =
      minimum_detectable_difference(halves->standard_error, halves->degrees_of_freedom);
  if (margin && outcome.unit == "m") {
    found.equivalence = equivalence_p_value(*halves, *margin);
    const double times = found.detectable_difference / *margin;
    found.runs_needed = std::ceil(static_cast<double>(found.runs) * times * times);
  }
  return found;
}

ShapeTrends trends_of(const Comparison& comparison, std::uint32_t file) {
  ShapeTrends result;
  result.file = file;
  const CampaignResults& results = comparison.results[file];
  const std::vector<const RunRow*> rows = select_rows_of_file(comparison, file);
  std::set<std::uint32_t> blocks;
  for (const RunRow* row : rows) blocks.insert(row->record->block);
  if (results.persistent_blocks || blocks.size() < kMinBlocksForPower) return result;
  const bool crossed_masses = has_crossed_masses(rows);
  std::vector<std::pair<ShapeProperty, Grouping>> groupings;
  for (const ShapeProperty& property : properties_of(results)) {
    Grouping grouping = grouping_by(property, rows, crossed_masses);
    if (differs(property, grouping.trend)) groupings.emplace_back(property, std::move(grouping));
  }
  for (const RunOutcome& outcome : collect_run_outcomes(comparison, file, rows)) {
    std::vector<ShapeTrend> found;
    std::vector<double> p_values;
    for (auto& [property, grouping] : groupings) {
      const auto trend = trend_of(outcome, property, grouping, comparison.margin);
      if (!trend) continue;
      found.push_back(*trend);
      p_values.push_back(trend->trend.p_value);
    }
    const std::vector<double> corrected = holm_adjusted(p_values);
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i].corrected_p = corrected[i];
      result.trends.push_back(found[i]);
    }
  }
  return result;
}

}  // namespace

std::vector<ShapeTrends> compute_shape_trends(const Comparison& comparison) {
  std::vector<ShapeTrends> all;
  for (std::uint32_t file = 0; file < comparison.results.size(); ++file) {
    all.push_back(trends_of(comparison, file));
  }
  return all;
}

}  // namespace clast
