// Tables with a row per run or per event of a run, in order of file, run and time.
#include "report/tables/comparison_columns.hpp"
#include "study/results/stored_columns.hpp"

namespace clast {

using namespace report_detail;
namespace {

struct RunImpact {
  const RunRow& run;
  const Impact& impact;
};

/// A run whose block stayed among others.
struct RunStay {
  const RunRow& run;
  const PersistentBlockRecord& persistent_blocks;
};

/// Columns of runs.csv for rows that belong to a run.
template <class Row, class Run>
TableColumns<Row> of_run(const std::vector<std::string>& names, const Run& run) {
  return adapt_columns<Row>(selected_columns(run_columns(), names), [run](const Row& row) {
    return ComparisonRow<RunRow>{row.comparison, run(row)};
  });
}

/// Events of all files, each with its run.
template <class Joined, class Event>
std::vector<Joined> with_runs(const Comparison& comparison,
                              std::vector<Event> CampaignResults::*events) {
  std::vector<Joined> joined;
  for (std::size_t i = 0, file = 0; file < comparison.results.size(); ++file) {
    for (const Event& event : comparison.results[file].*events) {
      // Events and rows are in order of file and run.
      while (i < comparison.rows.size() &&
             (comparison.rows[i].file != file || comparison.rows[i].record->run < event.run)) {
        ++i;
      }
      if (i == comparison.rows.size()) break;
      joined.push_back({comparison.rows[i], event});
    }
  }
  return joined;
}

const TableColumns<ComparisonRow<RunImpact>>& impact_columns() {
  using Row = ComparisonRow<RunImpact>;
  const auto run = [](const Row& row) -> const RunRow& { return row->run; };
  const auto results = [](const Row& row) -> const CampaignResults& {
    return row.comparison.results[row->run.file];
  };
  const auto stored = [](const std::vector<std::string>& names) {
    return adapt_columns<Row>(selected_columns(stored_impact_columns(), names),
                              [](const Row& row) -> const Impact& { return row->impact; });
  };
  const auto energy = [](const char* name, double Impact::*value) {
    return TableColumn<Row>{name, "J", "kinetic energy at the first and at the last contact",
                            [value](const Row& row) { return row->impact.*value; }};
  };
  static const auto columns = concatenated_columns<Row>(
      {of_run<Row>({"run", "block", "class", "shape"}, run),
       {{"zone", "", "name of the ground zone of the first contact",
         [=](const Row& row) { return results(row).zone_names[row->impact.zone]; }}},
       stored({"time_s", "contact_s"}),
       array_columns<Row>(
           {"x_m", "y_m", "z_m"}, "m", "position at the first contact",
           [=](const Row& row) { return results(row).frame.to_map(row->impact.position); }),
       stored({"speed_before_m_s", "speed_after_m_s"}),
       {energy("translational_energy_before_j", &Impact::translational_before),
        energy("translational_energy_after_j", &Impact::translational_after),
        energy("rotational_energy_before_j", &Impact::rotational_before),
        energy("rotational_energy_after_j", &Impact::rotational_after)},
       stored({"depth_m"}),
       of_run<Row>({"file"}, run)});
  return columns;
}

const TableColumns<ComparisonRow<RunStay>>& stay_columns() {
  using Row = ComparisonRow<RunStay>;
  const auto run = [](const Row& row) -> const RunRow& { return row->run; };
  const auto each = [](const Row& row) -> std::uint64_t {
    return row.comparison.results[row->run.file].runs_per_realisation();
  };
  static const auto columns = concatenated_columns<Row>(
      {of_run<Row>({"run", "block", "class", "shape"}, run),
       {{"realisation", "", "number of the realisation, from 1",
         [=](const Row& row) { return row->persistent_blocks.run / each(row) + 1; }},
        {"order", "", "number of the release in the realisation, from 1",
         [=](const Row& row) { return row->persistent_blocks.run % each(row) + 1; }}},
       blank_unknown_cells(
           adapt_columns<Row>(selected_columns(stored_persistent_block_columns(),
                                               {"released_at_s", "raised_m", "moved_later_m",
                                                "blocks_hit", "removed_at_s"}),
                              [](const Row& row) -> const PersistentBlockRecord& {
                                return row->persistent_blocks;
                              }),
           [](const Row& row) -> const CampaignResults& {
             return row.comparison.results[row->run.file];
           }),
       of_run<Row>({"file"}, run)});
  return columns;
}

std::vector<RunImpact> impact_rows(const Comparison& comparison) {
  return with_runs<RunImpact>(comparison, &CampaignResults::impacts);
}

std::vector<RunStay> stay_rows(const Comparison& comparison) {
  return with_runs<RunStay>(comparison, &CampaignResults::persistent_block_records);
}

}  // namespace

const TableColumns<ComparisonRow<BarrierCrossing>>& report_detail::crossing_columns() {
  using Row = ComparisonRow<BarrierCrossing>;
  const auto run = [](const Row& row) -> const RunRow& { return row.comparison.rows[row->row]; };
  const auto crossing = [](const Row& row) -> const Crossing& { return *row->crossing; };
  const auto line = [](const Row& row) -> const BarrierLine& {
    return row.comparison.lines[row->barrier];
  };
  const auto stored = [&](const std::vector<std::string>& names) {
    return adapt_columns<Row>(selected_columns(stored_crossing_columns(), names), crossing);
  };
  static const auto columns = concatenated_columns<Row>(
      {of_run<Row>({"run", "block", "class", "shape"}, run),
       {{"barrier", "", "name of the barrier; for a ring as in barriers.csv",
         [=](const Row& row) { return line(row).name; }},
        {"direction", "",
         "`forward` (from the left of the line to its right) or `backward`; for "
         "a ring `in` or `out`",
         [=](const Row& row) { return line(row).direction(crossing(row)); }},
        {"counted", "",
         "1 for the first crossing of the run at this barrier that counts; for a ring, for its "
         "first "
         "entry and for its first exit",
         [](const Row& row) { return std::uint64_t{row->counted ? 1u : 0u}; }}},
       stored({"time_s"}),
       array_columns<Row>({"x_m", "y_m", "z_m"}, "m", "position of the centre of mass",
                          &BarrierCrossing::position),
       stored({"height_m", "clearance_m"}),
       {{"speed_m_s", "m/s", "speed of the centre of mass",
         [=](const Row& row) { return crossing(row).velocity.norm(); }}},
       array_columns<Row>({"velocity_x_m_s", "velocity_y_m_s", "velocity_z_m_s"}, "m/s",
                          "velocity of the centre of mass",
                          [=](const Row& row) { return crossing(row).velocity; }),
       {{"rotation_rate_rad_s", "rad/s", "magnitude of the angular velocity",
         [=](const Row& row) { return crossing(row).angular_velocity.norm(); }}},
       array_columns<Row>(
           {"angular_velocity_x_rad_s", "angular_velocity_y_rad_s", "angular_velocity_z_rad_s"},
           "rad/s", "angular velocity along the world axes",
           [=](const Row& row) { return crossing(row).angular_velocity; }),
       stored({"translational_energy_j", "rotational_energy_j"}),
       {{"total_energy_j", "J", "translational plus rotational kinetic energy",
         [=](const Row& row) {
           return crossing(row).translational_energy + crossing(row).rotational_energy;
         }}},
       of_run<Row>({"file"}, run)});
  return columns;
}

std::vector<ComparisonTable> report_detail::make_run_tables() {
  return {make_comparison_table("runs", run_columns(), &Comparison::rows),
          make_comparison_table("crossings", crossing_columns(), &Comparison::crossings),
          make_comparison_table("impacts", impact_columns(), impact_rows),
          make_comparison_table("stays", stay_columns(), stay_rows)};
}

}  // namespace clast
