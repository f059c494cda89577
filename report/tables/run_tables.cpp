#include "report/tables/run_tables.hpp"

#include "classify/form.hpp"
#include "core/csv_text.hpp"

namespace clast {
namespace {

constexpr double kDegrees = 180.0 / kPi;

void cells(CsvText& csv, const Vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) csv.cell(vector[axis]);
}

void cells_of_run(CsvText& csv, const RunRow& row) {
  csv.count(row.record->run);
  csv.cell(std::string_view(row.block->id));
  csv.cell(std::string_view(row.block->sneed_folk));
  csv.cell(std::string_view(row.block->garcia));
}

// What the campaign planned for a run beyond block, point and orientation.
void cells_of_plan(CsvText& csv, const CampaignResults& results, const RunRow& row) {
  const BlockSummary& block = *row.block;
  csv.cell(std::string_view(block.library_block()));
  csv.cell(std::string_view(block.group));
  csv.cell(block.scale);
  csv.cell(block.volume);
  csv.cell(elongation_s_c(block.axes));
  const std::uint32_t point = row.record->point;
  csv.cell(std::string_view(release_set_of(results, point)));
  csv.count(row.record->ground_set);
  const std::uint32_t set = row.record->ground_set;
  csv.count(set < results.ground_sets.size() ? results.ground_sets[set].member : 0);
}

}  // namespace

std::string runs_csv(const Comparison& comparison) {
  CsvText csv;
  csv.header(
      "run,block,class,shape,point,orientation,stop_reason,duration_s,stop_x_m,stop_y_m,stop_z_m,"
      "runout_m,lateral_deg,max_speed_m_s,max_penetration_m,energy_error,"
      "file,mass_kg,start_x_m,start_y_m,start_z_m,path_length_m,settled_penetration_m,below_ground,"
      "contact_steps,impacts,stop_qw,stop_qx,stop_qy,stop_qz,energy_initial_j,energy_final_j,"
      "energy_normal_j,energy_friction_j,energy_rolling_j,energy_reassigned_j,message,"
      "library_block,block_group,scale,volume_m3,s_c,release_set,ground_set,ensemble_member,"
      "contact_time_s,mean_contact_points,most_contact_points,longest_flight_m,max_energy_j,"
      "max_spin_rad_s");
  for (const RunRow& row : comparison.rows) {
    const ReleaseResult& result = row.record->result;
    cells_of_run(csv, row);
    csv.count(row.record->point);
    csv.count(row.record->orientation);
    csv.cell(std::string_view(name_of(result.stop_reason)));
    csv.cell(result.duration);
    cells(csv, row.stop);
    csv.cell(row.runout);
    csv.cell(row.lateral * kDegrees);
    csv.cell(result.max_speed);
    csv.cell(result.max_penetration);
    csv.cell(result.energy.error);
    csv.count(row.file + 1);
    csv.cell(row.block->mass);
    cells(csv, row.start);
    csv.cell(result.path_length);
    csv.cell(result.settled_penetration);
    csv.count(result.below_ground ? 1 : 0);
    csv.count(result.contact_steps);
    csv.count(result.impacts);
    const Quat& q = result.final_state.orientation;
    for (const double part : {q.w(), q.x(), q.y(), q.z()}) csv.cell(part);
    const EnergyLedger& energy = result.energy;
    for (const double part : {energy.initial, energy.final, energy.normal, energy.friction,
                              energy.rolling, energy.reassigned}) {
      csv.cell(part);
    }
    csv.cell(std::string_view(result.message));
    cells_of_plan(csv, comparison.results[row.file], row);
    const ContactStatistics& contacts = row.record->contacts;
    csv.cell(contacts.contact_time);
    csv.cell(contacts.mean_points);
    csv.count(contacts.most_points);
    csv.cell(contacts.longest_flight);
    csv.cell(contacts.max_energy);
    csv.cell(contacts.max_spin);
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
