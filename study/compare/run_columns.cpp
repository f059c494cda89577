#include "study/compare/run_columns.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "classify/form.hpp"
#include "core/angle.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "study/results/stored_columns.hpp"

namespace clast {
namespace {

using Row = ComparisonRow<RunRow>;

const CampaignResults& results_of(const Row& row) { return row.comparison.results[row->file]; }

std::uint64_t ensemble_member(const Row& row) {
  const std::vector<GroundParameterSet>& sets = results_of(row).ground_sets;
  const std::uint32_t set = row->record->ground_set;
  return set < sets.size() ? sets[set].member : 0;
}

/// Columns that are not in the results file: of block, comparison and map.
TableColumns<Row> own_columns() {
  const auto block = [](const Row& row) -> const BlockSummary& { return *row->block; };
  return concatenated_columns<Row>(
      {{{"block", "", "id of the block", [=](const Row& r) { return block(r).id; }},
        {"class", "", "Sneed and Folk class", [=](const Row& r) { return block(r).sneed_folk; }},
        {"zingg", "", "Zingg class", [=](const Row& r) { return block(r).zingg; }},
        {"shape", "", "`compact` or `elongated`", [=](const Row& r) { return block(r).garcia; }},
        {"mass_kg", "kg", "mass of the block", [=](const Row& r) { return block(r).mass; }},
        {"library_block", "", "library block from which the block was made",
         [=](const Row& r) { return block(r).library_block(); }},
        {"parent", "",
         "block from which `clast vary` or `vary` of the campaign made the "
         "block; or empty",
         [=](const Row& r) { return block(r).parent; }},
        {"variation", "", "variation by which the block was made, such as `stretch to 0.8, 0.5`",
         [=](const Row& r) { return block(r).variation; }},
        {"block_group", "", "group of the block in the campaign",
         [=](const Row& r) { return block(r).group; }},
        {"scale", "", "factor on the lengths of the library block",
         [=](const Row& r) { return block(r).scale; }},
        {"volume_m3", "m^3", "volume of the block as simulated",
         [=](const Row& r) { return block(r).volume; }},
        {"s_c", "", "elongation index of the block as simulated",
         [=](const Row& r) { return elongation_index(block(r).axes); }}},
       array_columns<Row>({"L_m", "I_m", "S_m"}, "m", "sides of the smallest box",
                          [=](const Row& r) {
                            const Axes& axes = block(r).axes;
                            return Vec3(axes.L, axes.I, axes.S);
                          }),
       array_columns<Row>({"start_x_m", "start_y_m", "start_z_m"}, "m",
                          "position of the centre of mass at release", &RunRow::start),
       array_columns<Row>({"stop_x_m", "stop_y_m", "stop_z_m"}, "m",
                          "position of the centre of mass at the end", &RunRow::stop),
       {{"runout_m", "m",
         "runout along downslope, see "
         "[theory](theory/statistics.md#runout-and-lateral-angle)",
         &RunRow::runout},
        {"lateral_deg", "deg",
         "lateral angle from downslope, see "
         "[theory](theory/statistics.md#runout-and-lateral-angle)",
         [](const Row& r) { return r->lateral * kDegreesPerRadian; }},
        {"file", "", "number of the results file",
         [](const Row& r) { return std::uint64_t{r->file} + 1; }},
        {"stop_reason", "", "`rest`, `left_terrain`, `max_time`, `error`",
         [](const Row& r) { return name_of(r->record->result.stop_reason); }},
        {"release_set", "", "name of the release set in the campaign",
         [](const Row& r) { return find_release_set(results_of(r), r->record->point); }},
        {"ground_set", "", "number of the ground set; ground_sets.csv has the parameters",
         [](const Row& r) { return std::uint64_t{r->record->ground_set}; }},
        {"ensemble_member", "", "ensemble member of the ground set", ensemble_member},
        {"engine", "", "program that computed the run: `clast`, `rockable`", [](const Row& r) {
           const std::string& engine = results_of(r).engine;
           return engine.empty() ? std::string("clast") : engine;
         }}}});
}

/// Own columns first: where the file has one of the same name, it holds an index, or is local.
const TableColumns<Row>& all_columns() {
  static const TableColumns<Row> columns = concatenated_columns<Row>(
      {own_columns(),
       blank_unknown_cells(
           adapt_columns<Row>(stored_run_columns(),
                              [](const Row& row) -> const RunRecord& { return *row->record; }),
           results_of)});
  return columns;
}

const TableColumns<Row>& group_columns() {
  static const TableColumns<Row> columns = selected_columns(all_columns(), {"block",
                                                                            "class",
                                                                            "shape",
                                                                            "point",
                                                                            "orientation",
                                                                            "stop_reason",
                                                                            "max_speed_m_s",
                                                                            "file",
                                                                            "mass_kg",
                                                                            "impacts",
                                                                            "library_block",
                                                                            "parent",
                                                                            "variation",
                                                                            "block_group",
                                                                            "scale",
                                                                            "volume_m3",
                                                                            "s_c",
                                                                            "release_set",
                                                                            "ground_set",
                                                                            "ensemble_member",
                                                                            "longest_flight_m",
                                                                            "zingg",
                                                                            "L_m",
                                                                            "I_m",
                                                                            "S_m",
                                                                            "engine"});
  return columns;
}

/// Orders by number where there is one, then by text.
using Value = std::pair<double, std::string>;

Value value_of(const TableCell& cell) {
  if (const auto* number = std::get_if<double>(&cell))
    return {*number, format_significant(*number, 6)};
  if (const auto* whole = std::get_if<std::uint64_t>(&cell)) {
    return {static_cast<double>(*whole), std::to_string(*whole)};
  }
  const std::string& text = std::get<std::string>(cell);
  return {0.0, text.empty() ? "none" : text};
}

const TableColumn<Row>& group_column(const std::string& name) {
  std::string list;
  for (const TableColumn<Row>& column : group_columns()) {
    if (name == column.name) return column;
    list += (list.empty() ? "" : ", ") + column.name;
  }
  throw InputError("runs have no column \"" + name + "\" to be grouped by; there are " + list);
}

// The quarter of the sorted values that a number lies in: its bounds, in words.
Value quarter(const std::vector<double>& sorted, double value) {
  std::vector<double> bounds;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) bounds.push_back(quantile(sorted, share));
  std::size_t part = 0;
  while (part < 3 && value > bounds[part + 1]) ++part;
  return {static_cast<double>(part),
          format_significant(bounds[part], 4) + " to " + format_significant(bounds[part + 1], 4)};
}

}  // namespace

const TableColumns<Row>& run_columns() {
  static const TableColumns<Row> columns = selected_columns(all_columns(), {"run",
                                                                            "block",
                                                                            "class",
                                                                            "shape",
                                                                            "point",
                                                                            "orientation",
                                                                            "stop_reason",
                                                                            "duration_s",
                                                                            "stop_x_m",
                                                                            "stop_y_m",
                                                                            "stop_z_m",
                                                                            "runout_m",
                                                                            "lateral_deg",
                                                                            "max_speed_m_s",
                                                                            "max_penetration_m",
                                                                            "energy_error",
                                                                            "file",
                                                                            "mass_kg",
                                                                            "start_x_m",
                                                                            "start_y_m",
                                                                            "start_z_m",
                                                                            "path_length_m",
                                                                            "settled_penetration_m",
                                                                            "below_ground",
                                                                            "contact_steps",
                                                                            "impacts",
                                                                            "stop_qw",
                                                                            "stop_qx",
                                                                            "stop_qy",
                                                                            "stop_qz",
                                                                            "energy_initial_j",
                                                                            "energy_final_j",
                                                                            "energy_normal_j",
                                                                            "energy_friction_j",
                                                                            "energy_rolling_j",
                                                                            "energy_reassigned_j",
                                                                            "message",
                                                                            "library_block",
                                                                            "block_group",
                                                                            "scale",
                                                                            "volume_m3",
                                                                            "s_c",
                                                                            "release_set",
                                                                            "ground_set",
                                                                            "ensemble_member",
                                                                            "contact_time_s",
                                                                            "mean_contact_points",
                                                                            "most_contact_points",
                                                                            "longest_flight_m",
                                                                            "max_energy_j",
                                                                            "max_spin_rad_s",
                                                                            "engine",
                                                                            "parent",
                                                                            "variation"});
  return columns;
}

void append_column_groups(Comparison& comparison, const std::string& name) {
  const TableColumn<Row>& column = group_column(name);
  std::vector<Value> values;
  for (const RunRow& row : comparison.rows) {
    const CampaignResults& results = comparison.results[row.file];
    if (!results.has_contacts() && depends_on_contact_data(name)) {
      throw InputError(results.file.string() + ": its runs, computed by " + results.engine +
                       ", do not report their " + name + ", so they can't be grouped by it");
    }
    values.push_back(value_of(column.value({comparison, row})));
  }
  const std::set<Value> distinct(values.begin(), values.end());
  // Texts have the number 0.
  const bool numbers = distinct.begin()->first != distinct.rbegin()->first;
  if (numbers && distinct.size() > kMaxColumnGroups) {
    std::vector<double> sorted;
    for (const Value& value : values) sorted.push_back(value.first);
    std::sort(sorted.begin(), sorted.end());
    for (Value& value : values) value = quarter(sorted, value.first);
  }
  std::map<Value, std::vector<std::size_t>> rows;
  for (std::size_t i = 0; i < values.size(); ++i) rows[values[i]].push_back(i);
  for (auto& [value, members] : rows) {
    comparison.groups.push_back({name + " " + value.second, RunGroupKind::kColumn, value.second,
                                 name, std::nullopt, std::move(members)});
  }
}

}  // namespace clast
