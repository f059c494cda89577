#include "report/tables/run_tables.hpp"

#include "core/csv_text.hpp"
#include "study/run_columns.hpp"

namespace clast {
namespace {

void cells(CsvText& csv, const Vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) csv.cell(vector[axis]);
}

void cells_of_run(CsvText& csv, const RunRow& row) {
  csv.count(row.record->run);
  csv.cell(std::string_view(row.block->id));
  csv.cell(std::string_view(row.block->sneed_folk));
  csv.cell(std::string_view(row.block->garcia));
}

void cell(CsvText& csv, const RunCell& value) {
  if (const auto* count = std::get_if<std::uint64_t>(&value)) return csv.count(*count);
  if (const auto* number = std::get_if<double>(&value)) return csv.cell(*number);
  csv.cell(std::get<std::string>(value));
}

}  // namespace

std::string runs_csv(const Comparison& comparison) {
  std::string header;
  for (const RunColumn& column : run_columns()) {
    if (column.in_table()) header += (header.empty() ? "" : ",") + std::string(column.name);
  }
  CsvText csv;
  csv.header(header);
  for (const RunRow& row : comparison.rows) {
    for (const RunColumn& column : run_columns()) {
      if (column.in_table()) cell(csv, column.value(comparison.results[row.file], row));
    }
    csv.end_row();
  }
  return csv.take();
}

std::string crossings_csv(const Comparison& comparison) {
  CsvText csv;
  csv.header(
      "run,block,class,shape,barrier,direction,counted,time_s,x_m,y_m,z_m,height_m,clearance_m,"
      "speed_m_s,velocity_x_m_s,velocity_y_m_s,velocity_z_m_s,rotation_rate_rad_s,"
      "angular_velocity_x_rad_s,angular_velocity_y_rad_s,angular_velocity_z_rad_s,"
      "translational_energy_j,rotational_energy_j,total_energy_j,file");
  for (const CrossingRow& row : comparison.crossings) {
    const Crossing& crossing = *row.crossing;
    cells_of_run(csv, comparison.rows[row.row]);
    csv.cell(std::string_view(comparison.lines[row.barrier].name));
    csv.cell(std::string_view(comparison.lines[row.barrier].direction(crossing)));
    csv.count(row.counted ? 1 : 0);
    csv.cell(crossing.time);
    cells(csv, row.position);
    csv.cell(crossing.height);
    csv.cell(crossing.clearance);
    csv.cell(crossing.velocity.norm());
    cells(csv, crossing.velocity);
    csv.cell(crossing.angular_velocity.norm());
    cells(csv, crossing.angular_velocity);
    csv.cell(crossing.translational_energy);
    csv.cell(crossing.rotational_energy);
    csv.cell(crossing.translational_energy + crossing.rotational_energy);
    csv.count(comparison.rows[row.row].file + 1);
    csv.end_row();
  }
  return csv.take();
}

std::string impacts_csv(const Comparison& comparison) {
  CsvText csv;
  csv.header(
      "run,block,class,shape,zone,time_s,contact_s,x_m,y_m,z_m,speed_before_m_s,speed_after_m_s,"
      "translational_energy_before_j,translational_energy_after_j,rotational_energy_before_j,"
      "rotational_energy_after_j,depth_m,file");
  for (std::size_t i = 0, file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    for (const Impact& impact : results.impacts) {
      // Impacts and rows are in order of file and run.
      while (i < comparison.rows.size() &&
             (comparison.rows[i].file != file || comparison.rows[i].record->run < impact.run)) {
        ++i;
      }
      if (i == comparison.rows.size()) break;
      cells_of_run(csv, comparison.rows[i]);
      csv.cell(std::string_view(results.zone_names[impact.zone]));
      csv.cell(impact.time);
      csv.cell(impact.contact_duration);
      cells(csv, results.frame.map(impact.place));
      for (const double value : {impact.speed_before, impact.speed_after,
                                 impact.translational_before, impact.translational_after,
                                 impact.rotational_before, impact.rotational_after, impact.depth}) {
        csv.cell(value);
      }
      csv.count(file + 1);
      csv.end_row();
    }
  }
  return csv.take();
}

}  // namespace clast
