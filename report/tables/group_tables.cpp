// The tables of groups of runs, and of what they ran with.

#include <cmath>

#include "core/angle.hpp"
#include "report/tables/comparison_columns.hpp"
#include "report/text/contrast_text.hpp"
#include "study/campaign/ground_fields.hpp"

namespace clast {

using namespace report_detail;
namespace {

/// A group and where its runs came to rest.
struct GroupDeposit {
  const RunGroup& group;
  const DepositStatistics& deposit;
};

/// A ground zone in a ground set of a results file.
struct ZoneOfSet {
  std::size_t file = 0;
  std::size_t set = 0;
  std::size_t zone = 0;
};

struct Statistic {
  const char* name;
  double SampleSummary::*value;
};
const std::vector<Statistic> kAllStatistics = {{"mean", &SampleSummary::mean},
                                               {"std", &SampleSummary::std},
                                               {"median", &SampleSummary::median},
                                               {"p95", &SampleSummary::p95},
                                               {"max", &SampleSummary::max}};
const std::vector<Statistic> kMeanAndStd = {{"mean", &SampleSummary::mean},
                                            {"std", &SampleSummary::std}};
const std::vector<Statistic> kUpper = {
    {"mean", &SampleSummary::mean}, {"p95", &SampleSummary::p95}, {"max", &SampleSummary::max}};

/// Makes a column per statistic, whose name replaces `*` in `name`; NaN if nothing was measured.
/// @param summary  of a row, a function or a member
template <class Row, class Get>
TableColumns<Row> summary_columns(const std::vector<Statistic>& statistics, const std::string& name,
                                  const std::string& unit, const std::string& meaning,
                                  const Get& summary) {
  TableColumns<Row> columns;
  for (const Statistic& statistic : statistics) {
    std::string column = name;
    column.replace(column.find('*'), 1, statistic.name);
    columns.push_back({column, unit, meaning, [=, value = statistic.value](const Row& row) {
                         const SampleSummary& of_row = std::invoke(summary, row);
                         return of_row.count > 0 ? of_row.*value : NAN;
                       }});
  }
  return columns;
}

SampleSummary in_degrees(const SampleSummary& angle) {
  return {angle.count,
          angle.mean * kDegreesPerRadian,
          angle.std * kDegreesPerRadian,
          angle.median * kDegreesPerRadian,
          angle.p95 * kDegreesPerRadian,
          angle.max * kDegreesPerRadian};
}

template <class Item>
const std::string& group_name(const ComparisonRow<Item>& row) {
  return row.comparison.groups[row->group].name;
}

const TableColumns<ComparisonRow<GroupDeposit>>& deposit_columns() {
  using Row = ComparisonRow<GroupDeposit>;
  const auto stops = [](const Row& row) { return row->deposit.stops; };
  static const auto columns = concatenated_columns<Row>(
      {{{"group", "", "name of the group", [](const Row& row) { return row->group.name; }},
        {"count", "", "number of runs that came to rest; the statistics are over these runs",
         [=](const Row& row) { return stops(row).rest; }}},
       summary_columns<Row>(kAllStatistics, "runout_*_m", "m", "runout of the runs at rest",
                            [](const Row& row) { return row->deposit.runout; }),
       array_columns<Row>(
           {"mean_stop_x_m", "mean_stop_y_m", "mean_stop_z_m"}, "m", "mean position of the stops",
           [=](const Row& row) {
             return stops(row).rest > 0 ? row->deposit.mean_stop : Vec3(Vec3::Constant(NAN));
           }),
       summary_columns<Row>(kMeanAndStd, "lateral_*_deg", "deg", "lateral angle, with its sign",
                            [](const Row& row) { return in_degrees(row->deposit.lateral); }),
       {{"runs", "", "number of runs started", [](const Row& row) { return row->deposit.started; }},
        {"left_terrain", "", "number of runs that ended in this way",
         [=](const Row& row) { return stops(row).left_terrain; }},
        {"max_time", "", "number of runs that ended in this way",
         [=](const Row& row) { return stops(row).max_time; }},
        {"error", "", "number of runs that ended in this way",
         [=](const Row& row) { return stops(row).error; }}},
       array_columns<Row>({"downslope_x", "downslope_y"}, "",
                          "unit vector along which runout is measured",
                          [](const Row& row) { return row.comparison.downslope; })});
  return columns;
}

const TableColumns<ComparisonRow<GroupDifference>>& difference_columns() {
  using Row = ComparisonRow<GroupDifference>;
  const char* interval =
      "95 % confidence interval of the difference; empty if a group has a "
      "single realisation";
  const char* unit = "as `quantity`";
  static const TableColumns<Row> columns = {
      {"first", "", "names of the groups",
       [](const Row& row) { return row.comparison.groups[row->first].name; }},
      {"second", "", "names of the groups",
       [](const Row& row) { return row.comparison.groups[row->second].name; }},
      {"quantity", "",
       "`runout_m`, `lateral_deg`, `path_length_m` of runs that came to rest, `max_speed_m_s` of "
       "runs that did not fail, and, per barrier, `NAME speed_m_s`, `NAME total_energy_j`, "
       "`NAME height_m` of first crossings",
       &GroupDifference::quantity},
      {"first_runs", "", "number of values of each group", &GroupDifference::first_runs},
      {"second_runs", "", "number of values of each group", &GroupDifference::second_runs},
      {"release_points", "",
       "number of clusters for interval and test: release points, or "
       "realisations of persistent blocks",
       &GroupDifference::points},
      {"first_mean", unit, "mean of each group", &GroupDifference::first_mean},
      {"second_mean", unit, "mean of each group", &GroupDifference::second_mean},
      {"difference", unit, "first minus second", &GroupDifference::estimate},
      {"difference_low", unit, interval,
       [](const Row& row) { return interval_bounds(row->interval)[0]; }},
      {"difference_high", unit, interval,
       [](const Row& row) { return interval_bounds(row->interval)[1]; }},
      {"cliffs_delta", "", "effect sizes", &GroupDifference::cliffs_delta},
      {"hedges_g", "", "effect sizes", [](const Row& row) { return row->hedges_g.value_or(NAN); }},
      {"ks_distance", "", "Kolmogorov-Smirnov distance", &GroupDifference::ks_distance},
      {"p_value", "",
       "p-value from random permutations by release point, uncorrected; empty "
       "if a group has a single realisation",
       [](const Row& row) { return row->p_value.value_or(NAN); }},
      {"p_holm", "", "`p_value` with Holm's correction for `tests` tests",
       [](const Row& row) { return row->holm_p_value.value_or(NAN); }},
      {"tests", "", "number of tests that `p_holm` is corrected for",
       &GroupDifference::family_size},
      {"found", "", "1 if `p_holm` is below 0.05, else 0; empty without a test",
       [](const Row& row) -> TableCell {
         if (!row->holm_p_value) return NAN;
         return std::uint64_t{row->is_significant() ? 1u : 0u};
       }},
      {"words", "", "a sentence to quote",
       [](const Row& row) { return describe_effect(row.item, row.comparison); }}};
  return columns;
}

const TableColumns<ComparisonRow<MeasuredStopGroup>>& measured_columns() {
  using Row = ComparisonRow<MeasuredStopGroup>;
  using Measured = MeasuredStopGroup;
  const auto bounds = [](const char* low, const char* high, const char* unit,
                         std::optional<Interval> (*interval)(const Row&)) {
    return array_columns<Row>(
        {low, high}, unit, "95 % confidence interval; empty for a single realisation",
        [interval](const Row& row) { return interval_bounds(interval(row)); });
  };
  static const auto columns = concatenated_columns<Row>(
      {{{"group", "", "name of the group", group_name<Measured>},
        {"measured", "", "number of measured stops of the group", &Measured::measured},
        {"simulated", "", "number of simulated runs at rest", &Measured::simulated}},
       summary_columns<Row>(kAllStatistics, "runout_*_m", "m", "runout of measured stops",
                            &Measured::runout),
       summary_columns<Row>(kMeanAndStd, "lateral_*_deg", "deg", "lateral angle of measured stops",
                            [](const Row& row) { return in_degrees(row->lateral); }),
       {{"simulated_runout_mean_m", "m", "mean runout of simulated runs at rest",
         &Measured::simulated_runout},
        {"difference_m", "m", "mean runout, measured minus simulated",
         [](const Row& row) { return row->runout.mean - row->simulated_runout; }},
        {"cliffs_delta", "", "Cliff's delta of measured against simulated runout",
         &Measured::cliffs_delta},
        {"ks_distance", "", "Kolmogorov-Smirnov distance", &Measured::ks_distance},
        {"p_value", "", "p-value of the distance, uncorrected; empty for a single realisation",
         [](const Row& row) { return row->medians.p_value.value_or(NAN); }},
        {"p_holm", "", "`p_value` with Holm's correction for all groups",
         [](const Row& row) { return row->medians.holm_p_value.value_or(NAN); }}},
       array_columns<Row>(
           {"runout_q25_m", "runout_q75_m"}, "m", "quartiles of the runout of measured stops",
           [](const Row& row) { return Vec2(row->quartiles.low, row->quartiles.high); }),
       array_columns<Row>(
           {"simulated_runout_q25_m", "simulated_runout_median_m", "simulated_runout_q75_m"}, "m",
           "quartiles of the runout of simulated runs at rest",
           [](const Row& row) {
             const Quartiles& runout = row->simulated_quartiles;
             return Vec3(runout.low, runout.median, runout.high);
           }),
       {{"median_difference_m", "m", "median runout, measured minus simulated",
         [](const Row& row) { return row->medians.estimate; }}},
       bounds("median_difference_low_m", "median_difference_high_m", "m",
              [](const Row& row) { return row->medians.interval; }),
       bounds("ks_distance_low", "ks_distance_high", "",
              [](const Row& row) { return row->ks_interval; })});
  return columns;
}

const TableColumns<ComparisonRow<ProfileBin>>& profile_columns() {
  using Row = ComparisonRow<ProfileBin>;
  const char* along = "distance from each run's release point along downslope";
  static const auto columns = concatenated_columns<Row>(
      {{{"group", "", "name of the group", group_name<ProfileBin>},
        {"from_m", "m", along, &ProfileBin::from},
        {"to_m", "m", along, &ProfileBin::to},
        {"runs", "", "number of runs that passed there", &ProfileBin::runs}},
       summary_columns<Row>(kUpper, "energy_*_j", "J",
                            "statistics over runs of the largest kinetic energy of each run "
                            "between `from_m` and `to_m`",
                            &ProfileBin::energy),
       summary_columns<Row>(kUpper, "speed_*_m_s", "m/s",
                            "statistics over runs of the largest speed of each run between "
                            "`from_m` and `to_m`",
                            &ProfileBin::speed),
       summary_columns<Row>(kUpper, "height_*_m", "m",
                            "statistics over runs of the largest height of the centre of mass of "
                            "each run above the ground between `from_m` and `to_m`",
                            &ProfileBin::height)});
  return columns;
}

const TableColumns<ComparisonRow<ZoneOfSet>>& ground_set_columns() {
  using Row = ComparisonRow<ZoneOfSet>;
  const auto results = [](const Row& row) -> const CampaignResults& {
    return row.comparison.results[row->file];
  };
  const auto set = [=](const Row& row) -> const GroundParameterSet& {
    return results(row).ground_sets[row->set];
  };
  const auto ground = [=](const Row& row) -> const GroundParameters& {
    return set(row).zones[row->zone];
  };
  TableColumns<Row> parameters;
  for (const GroundParameterField& field : ground_parameter_fields()) {
    parameters.push_back({field.name, field.unit, field.meaning,
                          [=](const Row& row) { return ground(row).*field.value; }});
  }
  static const auto columns = concatenated_columns<Row>(
      {{{"file", "", "number of the results file", [](const Row& row) { return row->file + 1; }},
        {"ground_set", "", "as in runs.csv", &ZoneOfSet::set},
        {"block_group", "", "as in runs.csv", [=](const Row& row) { return set(row).group; }},
        {"ensemble_member", "", "as in runs.csv",
         [=](const Row& row) { return std::uint64_t{set(row).member}; }},
        {"zone", "", "name of the ground zone",
         [=](const Row& row) { return results(row).zone_names[row->zone]; }}},
       parameters});
  return columns;
}

std::vector<GroupDeposit> deposit_rows(const Comparison& comparison) {
  std::vector<GroupDeposit> deposits;
  for (std::size_t i = 0; i < comparison.groups.size(); ++i) {
    deposits.push_back({comparison.groups[i], comparison.deposits[i]});
  }
  return deposits;
}

std::vector<ZoneOfSet> ground_set_rows(const Comparison& comparison) {
  std::vector<ZoneOfSet> zones;
  for (std::size_t file = 0; file < comparison.results.size(); ++file) {
    const CampaignResults& results = comparison.results[file];
    for (std::size_t set = 0; set < results.ground_sets.size(); ++set) {
      for (std::size_t zone = 0; zone < results.ground_sets[set].zones.size(); ++zone) {
        zones.push_back({file, set, zone});
      }
    }
  }
  return zones;
}

}  // namespace

const TableColumns<BarrierGroupStatistics>& report_detail::barrier_table_columns() {
  using Row = BarrierGroupStatistics;
  const auto statistics = [](const char* name, const char* unit, const char* meaning,
                             SampleSummary Row::*summary) {
    return summary_columns<Row>(kAllStatistics, name, unit, meaning, summary);
  };
  static const auto columns = concatenated_columns<Row>(
      {{{"barrier", "", "name of the barrier; for a ring with `(in)` or `(out)`", &Row::barrier},
        {"group", "", "name of the group", &Row::group},
        {"runs", "",
         "number of runs started by the group in campaigns with this barrier, "
         "without failed runs",
         &Row::started},
        {"counted", "",
         "`either`: the first crossing of a run in any direction counts; "
         "`forward`: the first crossing from the left of the line to its right; "
         "for a ring `in` or `out`",
         &Row::counted},
        {"crossings", "", "number of these runs with a crossing that counts", &Row::crossed},
        {"backward", "",
         "number of runs that crossed from the right of the line to its left "
         "first, counted or not; 0 for a ring",
         &Row::backward},
        {"probability", "", "`crossings` / `runs`", &Row::probability}},
       array_columns<Row>({"probability_low", "probability_high"}, "",
                          "95 % confidence interval; empty for a single realisation",
                          [](const Row& row) { return interval_bounds(row.interval); }),
       statistics("height_*_m", "m", "height of the centre of mass above the ground below it",
                  &Row::height),
       statistics("clearance_*_m", "m", "height of the lowest skin point above the ground below it",
                  &Row::clearance),
       statistics(
           "top_*_m", "m",
           "upper bound of the height of the skin above the ground below the centre of mass: "
           "height of this centre plus the largest distance of a skin point from it",
           &Row::top),
       statistics("speed_*_m_s", "m/s", "speed of the centre of mass", &Row::speed),
       statistics("translational_energy_*_j", "J", "kinetic energy of the centre of mass",
                  &Row::translational),
       statistics("rotational_energy_*_j", "J", "kinetic energy of the rotation", &Row::rotational),
       statistics("total_energy_*_j", "J", "translational plus rotational kinetic energy",
                  &Row::total),
       statistics("rotation_rate_*_rad_s", "rad/s", "magnitude of the angular velocity",
                  &Row::rotation_rate)});
  return columns;
}

std::vector<ComparisonTable> report_detail::make_group_tables() {
  const auto measured_groups = [](const Comparison& comparison) {
    return comparison.measured ? comparison.measured->groups : std::vector<MeasuredStopGroup>();
  };
  return {make_comparison_table("barriers", barrier_table_columns(), &Comparison::barriers),
          make_comparison_table("deposits", deposit_columns(), deposit_rows),
          make_comparison_table("ground_sets", ground_set_columns(), ground_set_rows),
          make_comparison_table("differences", difference_columns(), &Comparison::differences),
          make_comparison_table("profiles", profile_columns(), &ComparisonAnalyses::profiles),
          make_comparison_table("measured", measured_columns(), measured_groups)};
}

}  // namespace clast
