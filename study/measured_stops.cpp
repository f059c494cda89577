#include "study/measured_stops.hpp"

#include <cmath>
#include <map>

#include "classify/delimited_text.hpp"
#include "core/csv_text.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/group_differences.hpp"
#include "core/number_text.hpp"
#include "core/sample_tests.hpp"
#include "core/text_file.hpp"
#include "study/comparison.hpp"

namespace clast {
namespace {

/// "X_m" is the column x.
std::string column_name(std::string_view field) {
  std::string name;
  for (const char c : field) {
    name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  if (name.ends_with("_m")) name.resize(name.size() - 2);
  return name;
}

using Columns = std::map<std::string, std::size_t>;

Columns columns_of(const Record& header, const std::string& file) {
  Columns columns;
  std::string list;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    columns.emplace(column_name(header.fields[i]), i);
    list += (list.empty() ? "" : ", ") + std::string(header.fields[i]);
  }
  for (const char* name : {"x", "y"}) {
    if (columns.contains(name)) continue;
    throw InputError(file + ":" + std::to_string(header.line) + ": has no column \"" + name +
                     "\"; the first line must name the columns, among them x and y; found " + list);
  }
  if (columns.contains("start_x") != columns.contains("start_y")) {
    throw InputError(file + ":" + std::to_string(header.line) +
                     ": start_x and start_y come together or not at all");
  }
  return columns;
}

std::string_view field(const Record& record, const Columns& columns, const std::string& name) {
  const auto column = columns.find(name);
  if (column == columns.end() || column->second >= record.fields.size()) return {};
  return record.fields[column->second];
}

double coordinate(const Record& record, const Columns& columns, const std::string& name,
                  const std::string& file) {
  const std::string text(field(record, columns, name));
  const std::optional<double> value = number_in(text);
  if (value && std::isfinite(*value)) return *value;
  throw InputError(file + ":" + std::to_string(record.line) + ": " + name + " \"" + text +
                   "\" is not a number");
}

Vec2 mean_release(const Comparison& comparison) {
  // Summed from the first: map coordinates of 5e6 m would cost digits.
  const Vec2 first = comparison.rows.front().start.head<2>();
  Vec2 sum = Vec2::Zero();
  for (const RunRow& row : comparison.rows) sum += row.start.head<2>() - first;
  return first + sum / static_cast<double>(comparison.rows.size());
}

bool belongs(const MeasuredStop& stop, const Group& group) {
  switch (group.kind) {
    case GroupKind::kAll:
      return true;
    case GroupKind::kBlock:
      return stop.block == group.key;
    case GroupKind::kGarcia:
      return stop.shape == group.key;
    case GroupKind::kSneedFolk:
    case GroupKind::kColumn:
      break;
  }
  return false;
}

}  // namespace

MeasuredStops read_measured_stops(const std::filesystem::path& path) {
  const std::string text = read_text_file(path), file = path.string();
  DelimitedText table(text, file);
  Record record;
  MeasuredStops measured{path, sha256(text), {}, {}};
  if (!table.next(record)) throw InputError(file + ": is empty; it must be a table of stops");
  const Columns columns = columns_of(record, file);
  while (table.next(record)) {
    MeasuredStop stop;
    stop.place = {coordinate(record, columns, "x", file), coordinate(record, columns, "y", file)};
    if (columns.contains("start_x")) {
      stop.start = Vec2(coordinate(record, columns, "start_x", file),
                        coordinate(record, columns, "start_y", file));
    }
    stop.block = field(record, columns, "block");
    stop.shape = field(record, columns, "shape");
    measured.stops.push_back(std::move(stop));
  }
  if (measured.stops.empty()) throw InputError(file + ": names columns but holds no stop");
  return measured;
}

void hold_against(const Comparison& comparison, MeasuredStops& measured) {
  const Vec2 mean = mean_release(comparison);
  for (MeasuredStop& stop : measured.stops) {
    const Vec2 start = stop.start.value_or(mean);
    const Runout offset = runout(Vec3(start.x(), start.y(), 0.0),
                                 Vec3(stop.place.x(), stop.place.y(), 0.0), comparison.downslope);
    stop.runout = offset.along;
    stop.lateral = offset.lateral;
  }
  std::vector<double> p_values;
  for (std::size_t g = 0; g < comparison.groups.size(); ++g) {
    const Group& group = comparison.groups[g];
    if (group.file) continue;
    std::vector<double> seen, lateral, simulated;
    for (const MeasuredStop& stop : measured.stops) {
      if (!belongs(stop, group)) continue;
      seen.push_back(stop.runout);
      lateral.push_back(stop.lateral);
    }
    for (const std::size_t row : group.rows) {
      const RunRow& run = comparison.rows[row];
      if (run.record->result.stop_reason == StopReason::kRest) simulated.push_back(run.runout);
    }
    if (seen.empty() || simulated.empty()) continue;
    const TestResult test = *two_sample_ks(seen, simulated);
    measured.groups.push_back({g, seen.size(), simulated.size(), summarise(seen),
                               summarise(lateral), summarise(simulated).mean,
                               *cliffs_delta(seen, simulated), test.statistic, test.p_value, 1.0});
    p_values.push_back(test.p_value);
  }
  const std::vector<double> corrected = holm(p_values);
  for (std::size_t i = 0; i < corrected.size(); ++i) measured.groups[i].p_holm = corrected[i];
}

std::string measured_csv(const Comparison& comparison) {
  constexpr double kDegrees = 180.0 / kPi;
  CsvText csv;
  csv.header(
      "group,measured,simulated,runout_mean_m,runout_std_m,runout_median_m,runout_p95_m,"
      "runout_max_m,lateral_mean_deg,lateral_std_deg,simulated_runout_mean_m,difference_m,"
      "cliffs_delta,ks_distance,p_value,p_holm");
  if (!comparison.measured) return csv.take();
  for (const MeasuredGroup& group : comparison.measured->groups) {
    csv.cell(std::string_view(comparison.groups[group.group].name));
    csv.count(group.measured);
    csv.count(group.simulated);
    const Summary& runouts = group.runout;
    for (const double value :
         {runouts.mean, runouts.std, runouts.median, runouts.p95, runouts.max,
          group.lateral.mean * kDegrees, group.lateral.std * kDegrees, group.simulated_runout,
          runouts.mean - group.simulated_runout, group.cliffs_delta, group.ks_distance,
          group.p_value, group.p_holm}) {
      csv.cell(value);
    }
    csv.end_row();
  }
  return csv.take();
}

}  // namespace clast
