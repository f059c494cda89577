#include "study/run_columns.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "classify/form.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {
namespace {

constexpr double kDegrees = 180.0 / kPi;

std::uint64_t count(std::uint64_t value) { return value; }

std::uint64_t ensemble_member(const CampaignResults& results, const RunRow& row) {
  const std::uint32_t set = row.record->ground_set;
  return set < results.ground_sets.size() ? results.ground_sets[set].member : 0;
}

using Use = RunColumn::Use;
constexpr RunColumn kColumns[] = {
    {"run", "", "number of the run in its campaign, from 0", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return count(r.record->run); }},
    {"block", "", "id", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->id; }},
    {"class", "", "Sneed and Folk class", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->sneed_folk; }},
    {"shape", "", "`compact` or `elongated`", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->garcia; }},
    {"point", "", "index of the release point, from 0", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return count(r.record->point); }},
    {"orientation", "", "index of the orientation, from 0", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return count(r.record->orientation);
     }},
    {"stop_reason", "", "`rest`, `left_terrain`, `max_time`, `error`", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return name_of(r.record->result.stop_reason);
     }},
    {"duration_s", "s", "simulated time", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.record->result.duration; }},
    {"stop_x_m", "m", "centre of mass at the end", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.stop.x(); }},
    {"stop_y_m", "m", "centre of mass at the end", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.stop.y(); }},
    {"stop_z_m", "m", "centre of mass at the end", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.stop.z(); }},
    {"runout_m", "m", "along downslope, see [theory](theory.md#statistics)", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.runout; }},
    {"lateral_deg", "deg", "from downslope, see [theory](theory.md#statistics)", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.lateral * kDegrees; }},
    {"max_speed_m_s", "m/s", "largest speed of the centre", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.record->result.max_speed; }},
    {"max_penetration_m", "m", "largest overlap of any contact", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.max_penetration;
     }},
    {"energy_error", "", "share of the dissipated energy that the balance misses", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.energy.error;
     }},
    {"file", "", "number of the results file", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return count(r.file + 1); }},
    {"mass_kg", "kg", "of the block", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->mass; }},
    {"start_x_m", "m", "centre of mass at release", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.start.x(); }},
    {"start_y_m", "m", "centre of mass at release", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.start.y(); }},
    {"start_z_m", "m", "centre of mass at release", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.start.z(); }},
    {"path_length_m", "m", "of the centre", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.path_length;
     }},
    {"settled_penetration_m", "m", "largest overlap at the end", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.settled_penetration;
     }},
    {"below_ground", "", "1 if the run ended below ground, else 0", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return count(r.record->result.below_ground ? 1 : 0);
     }},
    {"contact_steps", "", "time steps with a contact", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return count(r.record->result.contact_steps);
     }},
    {"impacts", "", "flights ended by a contact", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return count(r.record->result.impacts);
     }},
    {"stop_qw", "", "orientation at the end, world from principal frame", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.final_state.orientation.w();
     }},
    {"stop_qx", "", "orientation at the end, world from principal frame", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.final_state.orientation.x();
     }},
    {"stop_qy", "", "orientation at the end, world from principal frame", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.final_state.orientation.y();
     }},
    {"stop_qz", "", "orientation at the end, world from principal frame", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.final_state.orientation.z();
     }},
    {"energy_initial_j", "J", "kinetic + potential + stored, at the start", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.energy.initial;
     }},
    {"energy_final_j", "J", "kinetic + potential + stored, at the end", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.energy.final;
     }},
    {"energy_normal_j", "J", "dissipated by the normal law", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.energy.normal;
     }},
    {"energy_friction_j", "J", "dissipated by sliding", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.energy.friction;
     }},
    {"energy_rolling_j", "J", "dissipated by rolling resistance", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.energy.rolling;
     }},
    {"energy_reassigned_j", "J", "lost (gained, if negative) where contacts or weights change",
     Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->result.energy.reassigned;
     }},
    {"message", "", "of a run that ended with an error", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.record->result.message; }},
    {"library_block", "", "the block in the library that it is made from", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->library_block(); }},
    {"block_group", "", "group of the block in the campaign", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->group; }},
    {"scale", "", "factor on the lengths of the block in the library", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->scale; }},
    {"volume_m3", "m^3", "of the block as it ran", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->volume; }},
    {"s_c", "", "of the block as it ran", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return elongation_s_c(r.block->axes);
     }},
    {"release_set", "", "of the campaign", Use::kBoth,
     [](const CampaignResults& c, const RunRow& r) -> RunCell {
       return release_set_of(c, r.record->point);
     }},
    {"ground_set", "", "of the campaign; ground_sets.csv has the parameters", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return count(r.record->ground_set);
     }},
    {"ensemble_member", "", "of the ground set", Use::kBoth,
     [](const CampaignResults& c, const RunRow& r) -> RunCell {
       return count(ensemble_member(c, r));
     }},
    {"contact_time_s", "s", "as in [results](#results-hdf5)", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->contacts.contact_time;
     }},
    {"mean_contact_points", "", "as in [results](#results-hdf5)", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->contacts.mean_points;
     }},
    {"most_contact_points", "", "as in [results](#results-hdf5)", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return count(r.record->contacts.most_points);
     }},
    {"longest_flight_m", "m", "as in [results](#results-hdf5)", Use::kBoth,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->contacts.longest_flight;
     }},
    {"max_energy_j", "J", "as in [results](#results-hdf5)", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->contacts.max_energy;
     }},
    {"max_spin_rad_s", "rad/s", "as in [results](#results-hdf5)", Use::kTable,
     [](const CampaignResults&, const RunRow& r) -> RunCell {
       return r.record->contacts.max_spin;
     }},
    {"zingg", "", "Zingg class", Use::kGroups,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->zingg; }},
    {"L_m", "m", "side of the smallest box", Use::kGroups,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->axes.L; }},
    {"I_m", "m", "side of the smallest box", Use::kGroups,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->axes.I; }},
    {"S_m", "m", "side of the smallest box", Use::kGroups,
     [](const CampaignResults&, const RunRow& r) -> RunCell { return r.block->axes.S; }},
};

/// Orders by number where there is one, then by text.
using Value = std::pair<double, std::string>;

Value value_of(const RunCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return {*number, with_digits(*number, 6)};
  if (const auto* whole = std::get_if<std::uint64_t>(&cell)) {
    return {static_cast<double>(*whole), std::to_string(*whole)};
  }
  const std::string& text = std::get<std::string>(cell);
  return {0.0, text.empty() ? "none" : text};
}

const RunColumn& column_named(const std::string& name) {
  std::string list;
  for (const RunColumn& column : run_columns()) {
    if (!column.groups()) continue;
    if (name == column.name) return column;
    list += (list.empty() ? "" : ", ") + std::string(column.name);
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
          with_digits(bounds[part], 4) + " to " + with_digits(bounds[part + 1], 4)};
}

}  // namespace

std::span<const RunColumn> run_columns() { return kColumns; }

void append_column_groups(Comparison& comparison, const std::string& name) {
  const RunColumn& column = column_named(name);
  std::vector<Value> values;
  for (const RunRow& row : comparison.rows) {
    values.push_back(value_of(column.value(comparison.results[row.file], row)));
  }
  const std::set<Value> distinct(values.begin(), values.end());
  // Texts have the number 0.
  const bool numbers = distinct.begin()->first != distinct.rbegin()->first;
  if (numbers && distinct.size() > kMostValues) {
    std::vector<double> sorted;
    for (const Value& value : values) sorted.push_back(value.first);
    std::sort(sorted.begin(), sorted.end());
    for (Value& value : values) value = quarter(sorted, value.first);
  }
  std::map<Value, std::vector<std::size_t>> rows;
  for (std::size_t i = 0; i < values.size(); ++i) rows[values[i]].push_back(i);
  for (auto& [value, members] : rows) {
    comparison.groups.push_back({name + " " + value.second, GroupKind::kColumn, value.second, name,
                                 std::nullopt, std::move(members)});
  }
}

}  // namespace clast
