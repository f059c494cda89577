#include "study/compare/measured_stops.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/files/column_heading.hpp"
#include "core/files/delimited_text.hpp"
#include "core/files/digest.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/random.hpp"
#include "core/statistics/bootstrap.hpp"
#include "core/statistics/effect_sizes.hpp"
#include "core/statistics/sample_tests.hpp"
#include "mesh/coordinate_columns.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/compare/comparison.hpp"
#include "study/results/runout.hpp"

namespace clast {

using namespace study_detail;
namespace {

using Columns = std::map<std::string, std::size_t>;

Columns columns_of(const Record& header, const std::string& file) {
  Columns columns;
  std::string list;
  const auto refuse = [&](const std::string& problem) {
    throw InputError(file + ":" + std::to_string(header.line) + ": " + problem);
  };
  const auto add = [&](const std::string& name, std::size_t column) {
    if (!columns.emplace(name, column).second) {
      refuse("has two columns \"" + name + "\"; keep only one of them");
    }
    const ColumnHeading heading = parse_heading(header.fields[column]);
    if (heading.length_unit && heading.length_unit->factor != 1.0) {
      refuse("\"" + escape_nonprintable(header.fields[column]) + "\" is in " +
             heading.length_unit->name + "; positions must be in m");
    }
  };
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    const std::string name = parse_heading(header.fields[i]).snake_case();
    if (name == "x" || name == "y" || name == "start_x" || name == "start_y" || name == "block" ||
        name == "shape") {
      add(name, i);
    }
    list += (list.empty() ? "" : ", ") + std::string(header.fields[i]);
  }
  if (!columns.contains("x") && !columns.contains("y")) {  // "Easting", "Rechtswert"
    for (std::size_t i = 0; i < header.fields.size(); ++i) {
      const std::optional<int> axis = parse_coordinate_axis(header.fields[i]);
      if (axis && *axis < 2) add(*axis == 0 ? "x" : "y", i);
    }
  }
  for (const char* name : {"x", "y"}) {
    if (columns.contains(name)) continue;
    refuse("has no column \"" + std::string(name) +
           "\"; the first line must name the columns, among them x and y; found " + list);
  }
  if (columns.contains("start_x") != columns.contains("start_y")) {
    refuse("has only one of start_x and start_y; give both or neither");
  }
  return columns;
}

std::string_view field(const Record& record, const Columns& columns, const std::string& name) {
  const auto column = columns.find(name);
  return column == columns.end() ? std::string_view() : record.fields[column->second];
}

double coordinate(const Record& record, const Columns& columns, const std::string& name,
                  const DelimitedTextReader& table, const std::string& file) {
  const std::string_view text = field(record, columns, name);
  const std::optional<double> value = parse_number_field(text, table.separator());
  if (value && kMapCoordinateRange.contains(*value)) return *value;
  throw InputError(
      file + ":" + std::to_string(record.line) + ": " + name + " \"" + std::string(text) +
      "\" is not a number " + kMapCoordinateRange.describe() +
      (is_ambiguous_number(text, table.separator()) ? "; " + std::string(kDecimalCommaHint) : ""));
}

Vec2 mean_release(const Comparison& comparison) {
  // Summed from the first: map coordinates of 5e6 m would cost digits.
  const Vec2 first = comparison.rows.front().start.head<2>();
  Vec2 sum = Vec2::Zero();
  for (const RunRow& row : comparison.rows) sum += row.start.head<2>() - first;
  return first + sum / static_cast<double>(comparison.rows.size());
}

/// Largest distance of the cumulative distributions of two samples in ascending order.
double largest_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double distance = 0.0;
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    const double value = std::min(a[i], b[k]);
    while (i < a.size() && a[i] == value) ++i;
    while (k < b.size() && b[k] == value) ++k;
    distance = std::max(distance, std::abs(static_cast<double>(i) / static_cast<double>(a.size()) -
                                           static_cast<double>(k) / static_cast<double>(b.size())));
  }
  return distance;
}

bool belongs(const MeasuredStop& stop, const RunGroup& group) {
  switch (group.kind) {
    case RunGroupKind::kAll:
      return true;
    case RunGroupKind::kBlock:
      return stop.block == group.key;
    case RunGroupKind::kGarcia:
      return stop.shape == group.key;
    case RunGroupKind::kSneedFolk:
    case RunGroupKind::kColumn:
      break;
  }
  return false;
}

Quartiles quartiles_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

struct BootstrapIntervals {
  Interval median_difference;
  Interval ks_distance;
};

/// Measured stops are drawn one by one, simulated ones by whole clusters (`cluster_index_of_run`);
/// by runs where there is one cluster only.
BootstrapIntervals bootstrap_intervals(
    const std::vector<double>& seen,
    const std::map<std::uint32_t, std::vector<double>>& by_cluster) {
  constexpr std::uint64_t kSeed = 20220310;  // any is good; a fixed one gives the same interval
  constexpr std::size_t kDraws = 1000, kMaxDrawn = 20'000'000;
  std::vector<std::vector<double>> clusters;
  std::size_t runs = 0;
  for (const auto& [cluster, values] : by_cluster) {
    clusters.push_back(values);
    runs += values.size();
  }
  if (clusters.size() == 1) {
    const std::vector<double> values = std::move(clusters.front());
    clusters.clear();
    for (const double value : values) clusters.push_back({value});
  }
  Random random(kSeed);
  std::vector<double> medians, distances;
  const std::size_t draws = std::clamp<std::size_t>(kMaxDrawn / (runs + seen.size()), 100, kDraws);
  for (std::size_t draw = 0; draw < draws; ++draw) {
    std::vector<double> a, b;
    for (std::size_t i = 0; i < seen.size(); ++i)
      a.push_back(seen[random.uniform_index(seen.size())]);
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      const std::vector<double>& cluster = clusters[random.uniform_index(clusters.size())];
      b.insert(b.end(), cluster.begin(), cluster.end());
    }
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    medians.push_back(quantile(a, 0.5) - quantile(b, 0.5));
    distances.push_back(largest_distance(a, b));
  }
  return {percentile_interval(std::move(medians)), percentile_interval(std::move(distances))};
}

constexpr std::size_t kMaxCurvePoints = 100;  // of a curve

/// Computes the curve at each value of the sample, or at `kMaxCurvePoints` values.
/// @param banded  with intervals
RunoutDistributionCurve curve_of(const ClusteredValues& stops, std::size_t clusters,
                                 bool banded = true) {
  std::vector<double> sorted = stops.values;
  std::sort(sorted.begin(), sorted.end());
  RunoutDistributionCurve curve;
  const std::size_t points = std::min(kMaxCurvePoints, sorted.size());
  for (std::size_t i = 0; i < points; ++i) {
    const double at = sorted[points == 1 ? 0 : i * (sorted.size() - 1) / (points - 1)];
    if (!curve.runout.empty() && curve.runout.back() == at) continue;
    ClusteredValues before{{}, stops.clusters};
    for (const double value : stops.values) before.values.push_back(value <= at ? 1.0 : 0.0);
    curve.runout.push_back(at);
    curve.fraction.push_back(summarise_sample(before.values).mean);
    if (!banded) continue;
    const Interval interval = clustered_proportion_interval(before, clusters);
    curve.low.push_back(interval.low);
    curve.high.push_back(interval.high);
  }
  return curve;
}

}  // namespace

ContrastVerdict judge_stop_agreement(const MeasuredStopGroup& group) {
  if (group.measured < kMinMeasuredStops) return ContrastVerdict::kTooFewValues;
  const ContrastVerdict verdict = group.medians.verdict();
  return verdict == ContrastVerdict::kInsignificantAfterCorrection ? ContrastVerdict::kSignificant
                                                                   : verdict;
}

MeasuredStops read_measured_stops(const std::filesystem::path& path) {
  const std::string file = path.string(), bytes = read_text_file(path);
  const DecodedText content = decode_table_text(bytes, file);
  DelimitedTextReader table(content.text, file);
  Record record;
  MeasuredStops measured{path, sha256(bytes), {}, {}};
  if (!table.read_record(record))
    throw InputError(file + ": is empty; it must be a table of stops");
  const Columns columns = columns_of(record, file);
  while (table.read_record(record)) {
    if (detect_summary_row_label(record.fields.front()) == SummaryRowLabel::kCertain) {
      throw InputError(file + ":" + std::to_string(record.line) + ": \"" +
                       escape_nonprintable(record.fields.front()) +
                       "\" is a sum of other rows; remove that row");
    }
    MeasuredStop stop;
    stop.position = {coordinate(record, columns, "x", table, file),
                     coordinate(record, columns, "y", table, file)};
    if (columns.contains("start_x")) {
      stop.start = Vec2(coordinate(record, columns, "start_x", table, file),
                        coordinate(record, columns, "start_y", table, file));
    }
    stop.block = field(record, columns, "block");
    stop.shape = field(record, columns, "shape");
    measured.stops.push_back(std::move(stop));
  }
  if (measured.stops.empty()) throw InputError(file + ": names columns but holds no stop");
  return measured;
}

void compare_measured_stops(const Comparison& comparison, MeasuredStops& measured) {
  const Vec2 mean = mean_release(comparison);
  for (MeasuredStop& stop : measured.stops) {
    const Vec2 start = stop.start.value_or(mean);
    const RunoutMeasures offset =
        compute_runout(Vec3(start.x(), start.y(), 0.0),
                       Vec3(stop.position.x(), stop.position.y(), 0.0), comparison.downslope);
    stop.runout = offset.along;
    stop.lateral = offset.lateral;
  }
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const RunGroup& group = comparison.groups[g];
    if (group.file) continue;
    std::vector<double> seen, lateral, simulated;
    std::map<std::uint32_t, std::vector<double>> by_cluster;
    RunClustering clusters(comparison.results);
    std::vector<std::uint32_t> cluster_of_run;
    for (const MeasuredStop& stop : measured.stops) {
      if (!belongs(stop, group)) continue;
      seen.push_back(stop.runout);
      lateral.push_back(stop.lateral);
    }
    for (const std::size_t row : group.rows) {
      const RunRow& run = comparison.rows[row];
      if (run.record->result.stop_reason != StopReason::kRest) continue;
      simulated.push_back(run.runout);
      cluster_of_run.push_back(clusters.of(run));
      by_cluster[cluster_of_run.back()].push_back(run.runout);
    }
    if (seen.empty() || simulated.empty()) continue;
    const TestResult test = *two_sample_ks_test(seen, simulated);
    MeasuredStopGroup found;
    found.group = g;
    found.measured = seen.size();
    found.simulated = simulated.size();
    found.runout = summarise_sample(seen);
    found.lateral = summarise_sample(lateral);
    found.quartiles = quartiles_of(seen);
    found.simulated_runout = summarise_sample(simulated).mean;
    found.simulated_quartiles = quartiles_of(simulated);
    found.medians.estimate = found.quartiles.median - found.simulated_quartiles.median;
    found.cliffs_delta = *cliffs_delta(seen, simulated);
    found.ks_distance = test.statistic;
    const bool tested = !clusters.has_single_realisation();
    if (tested) {
      const BootstrapIntervals intervals = bootstrap_intervals(seen, by_cluster);
      found.medians.interval = intervals.median_difference;
      found.ks_interval = intervals.ks_distance;
      found.medians.p_value = test.p_value;
    }
    found.curve = curve_of({seen, std::vector<std::uint32_t>(seen.size(), 0)}, 1);
    found.simulated_curve = curve_of({simulated, cluster_of_run}, clusters.count(), tested);
    measured.groups.push_back(std::move(found));
  }
  correct_multiple_tests(measured.groups, &MeasuredStopGroup::medians);
}

}  // namespace clast
