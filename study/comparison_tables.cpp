#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>

#include "classify/form.hpp"
#include "core/csv_text.hpp"
#include "core/error.hpp"
#include "core/text_file.hpp"
#include "core/version.hpp"
#include "study/block_stiffness.hpp"
#include "study/comparison.hpp"
#include "study/profiles.hpp"
#include "study/report/gis_layers.hpp"
#include "study/report/html_report.hpp"
#include "study/report/raster_files.hpp"

namespace clast {
namespace {

constexpr double kDegrees = 180.0 / kPi;

void cells(CsvText& csv, const Vec3& vector) {
  for (int axis = 0; axis < 3; ++axis) csv.cell(vector[axis]);
}

/// mean, std, median, p95, max; empty where nothing was measured.
void cells(CsvText& csv, const Summary& summary, double unit = 1.0) {
  if (summary.count == 0) return csv.empty_cells(5);
  for (const double value : {summary.mean, summary.std, summary.median, summary.p95, summary.max}) {
    csv.cell(value * unit);
  }
}

std::string summary_columns(std::string_view quantity, std::string_view unit) {
  std::string columns;
  for (const char* statistic : {"mean", "std", "median", "p95", "max"}) {
    columns.append(",").append(quantity).append("_").append(statistic).append("_").append(unit);
  }
  return columns;
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

// Lowest and highest of every quantity over the runs of a block; null where results have none.
nlohmann::ordered_json stiffness_json(const CampaignResults& results) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BlockStiffness& block : stiffness_by_block(results.blocks, results.runs)) {
    nlohmann::ordered_json row = {{"block", block.block}};
    for (const StiffnessValue& value : block.values) {
      row[value.name] = nullptr;
      if (!value.range.empty()) row[value.name] = {value.range.low, value.range.high};
    }
    list.push_back(row);
  }
  return list;
}

}  // namespace

const std::string& release_set_of(const CampaignResults& results, std::uint32_t point) {
  static const std::string none;
  if (point >= results.set_of_point.size()) return none;
  return results.release_sets[results.set_of_point[point]];
}

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

std::string barriers_csv(const Comparison& comparison) {
  CsvText csv;
  csv.header("barrier,group,runs,crossings,probability,probability_low,probability_high" +
             summary_columns("height", "m") + summary_columns("clearance", "m") +
             summary_columns("speed", "m_s") + summary_columns("translational_energy", "j") +
             summary_columns("rotational_energy", "j") + summary_columns("total_energy", "j") +
             summary_columns("rotation_rate", "rad_s"));
  for (const BarrierGroup& group : comparison.barriers) {
    csv.cell(std::string_view(group.barrier));
    csv.cell(std::string_view(group.group));
    csv.count(group.started);
    csv.count(group.crossed);
    csv.cell(group.probability);
    const Interval interval = wilson_interval(group.crossed, group.started);
    csv.cell(interval.low);
    csv.cell(interval.high);
    for (const Summary* summary :
         {&group.height, &group.clearance, &group.speed, &group.translational, &group.rotational,
          &group.total, &group.rotation_rate}) {
      cells(csv, *summary);
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

std::string ground_sets_csv(const Comparison& comparison) {
  CsvText csv;
  csv.header(
      "file,ground_set,block_group,ensemble_member,zone,energy_restitution,friction,"
      "rolling_friction");
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    for (std::size_t set = 0; set < results.ground_sets.size(); ++set) {
      const GroundSet& ground = results.ground_sets[set];
      for (std::size_t zone = 0; zone < ground.zones.size(); ++zone) {
        csv.count(file + 1);
        csv.count(set);
        csv.cell(std::string_view(ground.group));
        csv.count(ground.member);
        csv.cell(std::string_view(results.zone_names[zone]));
        csv.cell(ground.zones[zone].energy_restitution);
        csv.cell(ground.zones[zone].friction);
        csv.cell(ground.zones[zone].rolling_friction);
        csv.end_row();
      }
    }
  }
  return csv.take();
}

std::string deposits_csv(const Comparison& comparison) {
  CsvText csv;
  csv.header("group,count" + summary_columns("runout", "m") +
             ",mean_stop_x_m,mean_stop_y_m,mean_stop_z_m,lateral_mean_deg,lateral_std_deg,"
             "runs,left_terrain,max_time,error,downslope_x,downslope_y");
  for (std::size_t i = 0; i < comparison.groups.size(); ++i) {
    const DepositGroup& deposit = comparison.deposits[i];
    csv.cell(std::string_view(comparison.groups[i].name));
    csv.count(deposit.stops.rest);
    cells(csv, deposit.runout);
    if (deposit.stops.rest > 0) {
      cells(csv, deposit.mean_stop);
      csv.cell(deposit.lateral.mean * kDegrees);
      csv.cell(deposit.lateral.std * kDegrees);
    } else {
      csv.empty_cells(5);
    }
    csv.count(deposit.started);
    csv.count(deposit.stops.left_terrain);
    csv.count(deposit.stops.max_time);
    csv.count(deposit.stops.error);
    csv.cell(comparison.downslope.x());
    csv.cell(comparison.downslope.y());
    csv.end_row();
  }
  return csv.take();
}

std::string provenance_json(const Comparison& comparison) {
  nlohmann::ordered_json json;
  json["program_version"] = version();
  json["downslope"] = {comparison.downslope.x(), comparison.downslope.y()};
  json["downslope_from"] = comparison.downslope_asked ? "campaign" : "mean release-to-stop line";
  json["warnings"] = comparison.warnings;
  json["files"] = nlohmann::ordered_json::array();
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    json["files"].push_back({{"file", file + 1},
                             {"results", results.file.filename().string()},
                             {"program_version", results.program_version},
                             {"campaign_sha256", results.campaign_sha256},
                             {"inputs", results.inputs},
                             {"runs", results.runs.size()},
                             {"planned_runs", results.planned_runs},
                             {"stiffness", stiffness_json(results)},
                             {"campaign", results.campaign_text}});
  }
  if (comparison.measured) {
    json["measured"] = {{"file", comparison.measured->file.filename().string()},
                        {"sha256", comparison.measured->sha256},
                        {"stops", comparison.measured->stops.size()}};
  }
  // Names and paths may hold bytes that are not UTF-8; they must not stop the tables.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

FolderKind comparison_folder() {
  const auto owns = [](const std::filesystem::path& file) {
    static const std::set<std::string> kFiles = {
        "runs.csv",    "barriers.csv",    "crossings.csv",   "deposits.csv",
        "impacts.csv", "ground_sets.csv", "profiles.csv",    "measured.csv",
        "stops.gpkg",  "differences.csv", "provenance.json", "report.html"};
    const std::string folder = file.parent_path().string(), extension = file.extension().string();
    if (folder == "rasters") return extension == ".tif";
    if (folder == "animation") return extension == ".vtp" || extension == ".pvd";
    return kFiles.contains(file.string());
  };
  return {"comparison", "provenance.json", "\"downslope_from\"", owns};
}

std::vector<std::filesystem::path> write_comparison(const Comparison& comparison,
                                                    const std::filesystem::path& folder) {
  std::error_code code;
  if (std::filesystem::exists(folder, code) && !std::filesystem::is_directory(folder, code)) {
    throw InputError(folder.string() + ": is a file; name a folder for the tables and the report");
  }
  std::vector<std::filesystem::path> written;
  const auto write = [&](const char* name, const std::string& text) {
    written.push_back(folder / name);
    write_text_file(written.back(), text);
  };
  write("runs.csv", runs_csv(comparison));
  write("barriers.csv", barriers_csv(comparison));
  write("crossings.csv", crossings_csv(comparison));
  write("deposits.csv", deposits_csv(comparison));
  write("impacts.csv", impacts_csv(comparison));
  write("ground_sets.csv", ground_sets_csv(comparison));
  write("differences.csv", differences_csv(comparison));
  const std::vector<ProfileBin> bins = profiles(comparison);
  write("profiles.csv", profiles_csv(comparison, bins));
  if (comparison.measured) write("measured.csv", measured_csv(comparison));
  write("provenance.json", provenance_json(comparison));
  written.push_back(folder / "stops.gpkg");
  write_geopackage(written.back(), comparison);
  const std::vector<std::filesystem::path> rasters = write_rasters(
      folder / "rasters", path_rasters(comparison), comparison.results.front().frame.crs);
  written.insert(written.end(), rasters.begin(), rasters.end());
  write("report.html", html_report(comparison, bins));
  return written;
}

}  // namespace clast
