#include "study/results/stored_columns.hpp"

#include <algorithm>

#include "study/results/detail/results_layout.hpp"

namespace clast {

using namespace study_detail;
namespace {

TableCell cell_of(std::uint64_t value) { return value; }
TableCell cell_of(std::uint32_t value) { return std::uint64_t{value}; }
TableCell cell_of(bool value) { return std::uint64_t{value ? 1u : 0u}; }
TableCell cell_of(double value) { return value; }
TableCell cell_of(const std::string& value) { return value; }
TableCell cell_of(StopReason value) { return name_of(value); }

template <class Row>
TableColumns<Row> stored_columns() {
  TableColumns<Row> columns;
  visit_columns(kRowType<Row>, [&](const std::string& name, const std::string& unit,
                                   const std::string& meaning, const auto& field) {
    columns.push_back({name, unit, meaning,
                       [field](const Row& row) { return cell_of(std::invoke(field, row)); }});
  });
  return columns;
}

}  // namespace

bool depends_on_contact_data(std::string_view column) {
  static constexpr std::string_view kColumns[] = {"max_penetration_m",   "settled_penetration_m",
                                                  "energy_normal_j",     "energy_friction_j",
                                                  "energy_rolling_j",    "energy_reassigned_j",
                                                  "energy_error",        "contact_time_s",
                                                  "contact_steps",       "mean_contact_points",
                                                  "most_contact_points", "impacts",
                                                  "longest_flight_m",    "blocks_hit"};
  return std::find(std::begin(kColumns), std::end(kColumns), column) != std::end(kColumns);
}

const TableColumns<RunRecord>& stored_run_columns() {
  static const TableColumns<RunRecord> columns = stored_columns<RunRecord>();
  return columns;
}

const TableColumns<Crossing>& stored_crossing_columns() {
  static const TableColumns<Crossing> columns = stored_columns<Crossing>();
  return columns;
}

const TableColumns<Impact>& stored_impact_columns() {
  static const TableColumns<Impact> columns = stored_columns<Impact>();
  return columns;
}

const TableColumns<PersistentBlockRecord>& stored_persistent_block_columns() {
  static const TableColumns<PersistentBlockRecord> columns =
      stored_columns<PersistentBlockRecord>();
  return columns;
}

const TableColumns<EnergyRecord>& stored_energy_columns() {
  static const TableColumns<EnergyRecord> columns = stored_columns<EnergyRecord>();
  return columns;
}

}  // namespace clast
