#include "report/tables/group_tables.hpp"

#include <cmath>
#include <string_view>

#include "core/csv_text.hpp"

namespace clast {
namespace {

constexpr double kDegrees = 180.0 / kPi;

/// mean, std, median, p95, max; empty where nothing was measured.
void cells(CsvText& csv, const Summary& summary) {
  if (summary.count == 0) return csv.empty_cells(5);
  for (const double value : {summary.mean, summary.std, summary.median, summary.p95, summary.max}) {
    csv.cell(value);
  }
}

std::string summary_columns(std::string_view quantity, std::string_view unit) {
  std::string columns;
  for (const char* statistic : {"mean", "std", "median", "p95", "max"}) {
    columns.append(",").append(quantity).append("_").append(statistic).append("_").append(unit);
  }
  return columns;
}

}  // namespace

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
      for (const double part : deposit.mean_stop) csv.cell(part);
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

std::string differences_csv(const Comparison& comparison) {
  CsvText csv;
  csv.header(
      "first,second,quantity,first_runs,second_runs,release_points,first_mean,second_mean,"
      "difference,difference_low,difference_high,cliffs_delta,hedges_g,ks_distance,p_value,p_holm,"
      "tests,found,words");
  for (const Difference& one : comparison.differences) {
    csv.cell(std::string_view(comparison.groups[one.first].name));
    csv.cell(std::string_view(comparison.groups[one.second].name));
    csv.cell(std::string_view(one.quantity));
    csv.count(one.first_runs);
    csv.count(one.second_runs);
    csv.count(one.points);
    csv.cell(one.first_mean);
    csv.cell(one.second_mean);
    csv.cell(one.first_mean - one.second_mean);
    csv.cell(one.interval ? one.interval->low : NAN);
    csv.cell(one.interval ? one.interval->high : NAN);
    csv.cell(one.cliffs_delta);
    csv.cell(one.hedges_g.value_or(NAN));
    csv.cell(one.ks_distance);
    csv.cell(one.p_value);
    csv.cell(one.p_holm);
    csv.count(one.tests);
    csv.count(one.found() ? 1 : 0);
    csv.cell(std::string_view(in_words(one, comparison)));
    csv.end_row();
  }
  return csv.take();
}

std::string measured_csv(const Comparison& comparison) {
  CsvText csv;
  csv.header(
      "group,measured,simulated,runout_mean_m,runout_std_m,runout_median_m,runout_p95_m,"
      "runout_max_m,lateral_mean_deg,lateral_std_deg,simulated_runout_mean_m,difference_m,"
      "cliffs_delta,ks_distance,p_value,p_holm,runout_q25_m,runout_q75_m,simulated_runout_q25_m,"
      "simulated_runout_median_m,simulated_runout_q75_m,median_difference_m,"
      "median_difference_low_m,median_difference_high_m,ks_distance_low,ks_distance_high");
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
          group.p_value, group.p_holm, group.quartiles.low, group.quartiles.high,
          group.simulated_quartiles.low, group.simulated_quartiles.median,
          group.simulated_quartiles.high,
          group.quartiles.median - group.simulated_quartiles.median}) {
      csv.cell(value);
    }
    for (const Interval& interval : {group.median_difference, group.ks_interval}) {
      csv.cell(interval.low);
      csv.cell(interval.high);
    }
    csv.end_row();
  }
  return csv.take();
}

std::string profiles_csv(const Comparison& comparison, const std::vector<ProfileBin>& bins) {
  CsvText csv;
  csv.header(
      "group,from_m,to_m,runs,energy_mean_j,energy_p95_j,energy_max_j,speed_mean_m_s,"
      "speed_p95_m_s,speed_max_m_s,height_mean_m,height_p95_m,height_max_m");
  for (const ProfileBin& bin : bins) {
    csv.cell(std::string_view(comparison.groups[bin.group].name));
    csv.cell(bin.from);
    csv.cell(bin.to);
    csv.count(bin.runs);
    for (const Summary* summary : {&bin.energy, &bin.speed, &bin.height}) {
      if (summary->count == 0) {
        csv.empty_cells(3);
        continue;
      }
      for (const double value : {summary->mean, summary->p95, summary->max}) csv.cell(value);
    }
    csv.end_row();
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

}  // namespace clast
