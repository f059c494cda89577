// The tables of what blocks that stay leave behind.
#include <cmath>

#include "core/angle.hpp"
#include "report/tables/comparison_columns.hpp"
#include "report/text/contrast_text.hpp"

namespace clast {

using namespace report_detail;
namespace {

const TableColumns<DepositMeasures>& realisation_columns() {
  using Row = DepositMeasures;
  const auto degrees = [](const Vec3& from, const Vec3& to) {
    return kDegreesPerRadian * std::atan(height_length_ratio(from, to));
  };
  static const auto columns = concatenated_columns<Row>(
      {{{"realisation", "", "number of the realisation, from 1",
         [](const Row& row) { return row.realisation + 1; }},
        {"blocks", "", "number of released blocks", &Row::blocks},
        {"lying", "",
         "number of deposited blocks: blocks that came to rest and were not "
         "removed",
         &Row::deposited_blocks},
        {"left_terrain", "", "number of blocks that left the terrain", &Row::left_terrain},
        {"mass_kg", "kg", "mass of the deposited blocks", &Row::mass},
        {"volume_m3", "m3", "volume of the deposited blocks, without the space between them",
         &Row::volume}},
       array_columns<Row>({"first_x_m", "first_y_m", "first_z_m"}, "m",
                          "centre of mass of the deposited blocks at their starts",
                          &Row::start_centre),
       array_columns<Row>({"x_m", "y_m", "z_m"}, "m",
                          "centre of mass of the deposited blocks at their stops", &Row::centre),
       array_columns<Row>({"crest_x_m", "crest_y_m", "crest_z_m"}, "m",
                          "highest start of all blocks", &Row::crest),
       array_columns<Row>({"toe_x_m", "toe_y_m", "toe_z_m"}, "m",
                          "stop farthest from the crest in plan", &Row::toe),
       {{"centre_angle_deg", "deg", "slope of the line from the first to the last centre of mass",
         [=](const Row& row) { return degrees(row.start_centre, row.centre); }},
        {"travel_angle_deg", "deg", "slope of the line from crest to toe (Fahrb\xC3\xB6schung)",
         [=](const Row& row) { return degrees(row.crest, row.toe); }},
        {"area_m2", "m2", "area covered by the deposited blocks, in plan", &Row::area},
        {"bulk_volume_m3", "m3", "volume between the ground and the tops of the deposited blocks",
         &Row::bulk_volume},
        {"thickness_m", "m", "largest height of a block's top above the ground", &Row::thickness},
        {"first_volume_m3", "m3",
         "volume of all blocks of a rock mass at its start, without the space "
         "between them; else empty",
         &Row::start_volume},
        {"first_bulk_volume_m3", "m3",
         "volume between the ground and the tops of the blocks of a rock mass "
         "at its start; else empty",
         &Row::start_bulk_volume},
        {"file", "", "number of the results file", [](const Row& row) { return row.file + 1; }}}});
  return columns;
}

const TableColumns<DepositQuantitySummary>& realisation_figure_columns() {
  using Row = DepositQuantitySummary;
  const char* unit = "as `figure`";
  const char* spread = "standard deviation, smallest and largest value over realisations";
  const char* interval =
      "95 % confidence interval of the mean; empty for fewer than two "
      "realisations, or if their values are equal";
  static const TableColumns<Row> columns = {
      {"file", "", "number of the results file", [](const Row& row) { return row.file + 1; }},
      {"figure", "",
       "`lying`, `lying_share` (fraction of the released blocks), "
       "`left_terrain`, `volume_m3`; horizontal distance, drop and "
       "height-length ratio of the centre of mass: `centre_distance_m`, "
       "`centre_drop_m`, `centre_drop_ratio`; the same from crest to toe: "
       "`toe_distance_m`, `toe_drop_m`, `toe_drop_ratio`, with "
       "`travel_angle_deg`; `area_m2`, `bulk_volume_m3`, `solid_share` "
       "(fraction of rock in the bulk volume), `first_solid_share` (the same "
       "for a rock mass at its start), `mean_thickness_m` (bulk volume over "
       "area), `thickness_m`; `largest_kinetic_j` (largest kinetic energy of "
       "all blocks together), and fractions of the energy that contacts "
       "dissipated: `dissipated_by_friction`, `dissipated_by_rolling`, "
       "`dissipated_between_blocks`",
       [](const Row& row) { return deposit_quantities()[row.quantity].name; }},
      {"realisations", "", "number of realisations that have the figure",
       [](const Row& row) { return row.summary.count; }},
      {"mean", unit, "mean over realisations", [](const Row& row) { return row.summary.mean; }},
      {"mean_low", unit, interval, [](const Row& row) { return interval_bounds(row.interval)[0]; }},
      {"mean_high", unit, interval,
       [](const Row& row) { return interval_bounds(row.interval)[1]; }},
      {"std", unit, spread, [](const Row& row) { return row.summary.std; }},
      {"least", unit, spread, [](const Row& row) { return row.minimum; }},
      {"most", unit, spread, [](const Row& row) { return row.summary.max; }}};
  return columns;
}

const TableColumns<DepositQuantityDifference>& realisation_difference_columns() {
  using Row = DepositQuantityDifference;
  const char* unit = "as `figure`";
  const char* interval =
      "95 % confidence interval of the difference (Welch); empty for fewer "
      "than two realisations of either file, or if realisations do not differ";
  static const TableColumns<Row> columns = {
      {"first", "", "numbers of the results files",
       [](const Row& row) { return row.first.file + 1; }},
      {"second", "", "numbers of the results files",
       [](const Row& row) { return row.second.file + 1; }},
      {"figure", "", "as in realisation_figures.csv",
       [](const Row& row) { return deposit_quantities()[row.first.quantity].name; }},
      {"first_realisations", "", "number of realisations of each file that have the figure",
       [](const Row& row) { return row.first.summary.count; }},
      {"second_realisations", "", "number of realisations of each file that have the figure",
       [](const Row& row) { return row.second.summary.count; }},
      {"first_mean", unit, "mean of each file",
       [](const Row& row) { return row.first.summary.mean; }},
      {"second_mean", unit, "mean of each file",
       [](const Row& row) { return row.second.summary.mean; }},
      {"difference", unit, "first minus second", &Row::estimate},
      {"difference_low", unit, interval,
       [](const Row& row) { return interval_bounds(row.interval)[0]; }},
      {"difference_high", unit, interval,
       [](const Row& row) { return interval_bounds(row.interval)[1]; }},
      {"freedom", "", "degrees of freedom of the interval", &Row::degrees_of_freedom},
      {"p_value", "", "p-value of the hypothesis of no difference, uncorrected",
       [](const Row& row) { return row.p_value.value_or(NAN); }},
      {"p_holm", "", "`p_value` with Holm's correction for `tests` tests",
       [](const Row& row) { return row.holm_p_value.value_or(NAN); }},
      {"tests", "", "number of tests that `p_holm` is corrected for", &Row::family_size},
      {"distinguished", "", "1 if `p_holm` is below 0.05, else 0",
       [](const Row& row) {
         return std::uint64_t{row.verdict() == ContrastVerdict::kSignificant ? 1u : 0u};
       }},
      {"words", "", "a sentence to quote", [](const Row& row) { return describe_effect(row); }}};
  return columns;
}

const TableColumns<DepositMobility>& mobility_columns() {
  using Row = DepositMobility;
  const char* interval =
      "95 % confidence interval of the difference (Welch); empty for fewer "
      "than two realisations or points";
  static const TableColumns<Row> columns = {
      {"file", "", "number of the results file, which has persistent blocks",
       [](const Row& row) { return std::uint64_t{row.file} + 1; }},
      {"alone", "", "number of the results file of single runs",
       [](const Row& row) { return std::uint64_t{row.single_block_file} + 1; }},
      {"group", "", "`all` or `class NAME`: library blocks that both files have", &Row::group},
      {"realisations", "", "number of realisations with blocks at rest",
       [](const Row& row) { return row.together_runout.count; }},
      {"blocks", "", "number of blocks at rest, in all realisations", &Row::blocks},
      {"runs", "", "number of runs of single blocks at rest", &Row::runs},
      {"together_runout_m", "m", "mean runout of a realisation, mean over realisations",
       [](const Row& row) { return row.together_runout.mean; }},
      {"alone_runout_m", "m",
       "mean runout of the single runs of a release point, mean over points; "
       "mean over runs if there is one point",
       [](const Row& row) { return row.alone_runout.mean; }},
      {"difference_m", "m", "together minus alone",
       [](const Row& row) { return row.difference.estimate; }},
      {"difference_low_m", "m", interval,
       [](const Row& row) { return interval_bounds(row.difference.interval)[0]; }},
      {"difference_high_m", "m", interval,
       [](const Row& row) { return interval_bounds(row.difference.interval)[1]; }},
      {"p_value", "", "p-value of the hypothesis of no difference",
       [](const Row& row) { return row.difference.p_value.value_or(NAN); }},
      {"together_toe_m", "m", "largest runout of a realisation, mean over realisations",
       [](const Row& row) { return row.together_toe.mean; }},
      {"alone_toe_m", "m",
       "expected largest runout of as many single runs as a realisation has blocks",
       &Row::alone_toe},
      {"starts_apart_m", "m",
       "distance in plan between the mean start together and the mean start "
       "alone",
       &Row::start_distance},
      {"mass_ratio", "",
       "mean block mass of the joint runs divided by the mean block mass of the "
       "single runs",
       &Row::mass_ratio},
      {"words", "", "a sentence to quote", [](const Row& row) { return describe_effect(row); }}};
  return columns;
}

}  // namespace

std::vector<ComparisonTable> report_detail::make_deposit_tables() {
  const auto part = [](auto of, auto member) {
    return [=](const ComparisonAnalyses& analyses) -> const auto& {
      return (analyses.*of)().*member;
    };
  };
  using All = ComparisonAnalyses;
  return {make_comparison_table("realisations", realisation_columns(),
                                part(&All::deposit_results, &DepositResults::realisations)),
          make_comparison_table("realisation_figures", realisation_figure_columns(),
                                part(&All::deposit_comparison, &DepositQuantityComparison::files)),
          make_comparison_table(
              "realisation_differences", realisation_difference_columns(),
              part(&All::deposit_comparison, &DepositQuantityComparison::differences)),
          make_comparison_table("mobility", mobility_columns(), &All::deposit_mobility)};
}

}  // namespace clast
