// The tables of fabric and sorting of deposits.
#include <cmath>

#include "core/angle.hpp"
#include "report/tables/comparison_columns.hpp"
#include "report/tables/group_tables.hpp"

namespace clast {

using namespace report_detail;
namespace {

/// Of a mean over realisations: the mean, and its interval.
/// @param name  with `*` where "mean", "low" and "high" go
template <class Row>
TableColumns<Row> mean_columns(const std::string& name, const std::string& unit,
                               const std::string& meaning, RealisationMean Row::*mean) {
  const auto named = [&](const char* part) {
    std::string column = name;
    return column.replace(column.find('*'), 1, part);
  };
  const auto bound = [mean](double Interval::*end) {
    return [mean, end](const Row& row) {
      const std::optional<Interval>& interval = (row.*mean).interval;
      return interval ? (*interval).*end : NAN;
    };
  };
  const char* interval = "its 95 % confidence interval; empty below two realisations";
  return {{named("mean"), unit, meaning,
           [mean](const Row& row) {
             const Summary& summary = (row.*mean).summary;
             return summary.count > 0 ? summary.mean : NAN;
           }},
          {named("low"), unit, interval, bound(&Interval::low)},
          {named("high"), unit, interval, bound(&Interval::high)}};
}

std::uint64_t number_of(std::uint32_t file) { return std::uint64_t{file} + 1; }

}  // namespace

const TableColumns<FabricGroup>& report_detail::fabric_columns() {
  using Row = FabricGroup;
  static const auto columns = joined<Row>(
      {{{"file", "", "number of the results file",
         [](const Row& row) { return number_of(row.file); }},
        {"group", "",
         "`all`, `class NAME`, `sneed-folk NAME`, or `smallest third`, `middle third`, `largest "
         "third` of the volumes of the blocks that lie there",
         &Row::name},
        {"blocks", "", "that came to rest and were not removed", &Row::blocks},
        {"realisations", "", "that have any; means are over these, of the mean of each",
         &Row::realisations}},
       mean_columns<Row>("along_*_m", "m",
                         "distance along downslope from the highest start of the realisation",
                         &Row::along),
       mean_columns<Row>("ahead_*_m", "m",
                         "distance along downslope from the centre of mass of the deposit",
                         &Row::ahead),
       mean_columns<Row>("aside_*_m", "m",
                         "distance to either side of the line along downslope through the centre "
                         "of mass of the starts",
                         &Row::aside),
       mean_columns<Row>("height_*_m", "m", "of the centre above the ground without blocks",
                         &Row::height),
       mean_columns<Row>("relative_height_*", "",
                         "of the centre, over the thickness of the deposit there: 0.5 of a block "
                         "alone, less below others, more upon them",
                         &Row::relative_height),
       {{"trend_deg", "deg",
         "axial mean of the directions of the long axes (of L), from downslope to the right, -90 "
         "to 90",
         [](const Row& row) { return kDegreesPerRadian * row.trend.direction; }},
        {"trend_resultant", "",
         "mean resultant length of the doubled directions: 0 even, 1 parallel",
         [](const Row& row) { return row.trend.resultant; }},
        {"rayleigh_p", "",
         "of even directions, blocks taken as independent; empty below two realisations",
         [](const Row& row) { return row.rayleigh.value_or(NAN); }},
        {"rayleigh_realisations_p", "",
         "of even directions, where blocks of a realisation depend on each other; empty below two "
         "realisations",
         [](const Row& row) { return row.rayleigh_realisations.value_or(NAN); }},
        {"plunge_mean_deg", "deg", "of the long axes below the horizontal, over blocks",
         [](const Row& row) { return kDegreesPerRadian * row.plunge; }}},
       columns_of_list<Row>({"eigenvalue_1", "eigenvalue_2", "eigenvalue_3"}, "",
                            "of the orientation tensor of the long axes; their sum is 1",
                            &Row::eigenvalues)});
  return columns;
}

const TableColumns<NeighbourTest>& report_detail::neighbour_columns() {
  using Row = NeighbourTest;
  static const TableColumns<Row> columns = {
      {"file", "", "number of the results file",
       [](const Row& row) { return number_of(row.file); }},
      {"scheme", "", "of the classes, `garcia` or `sneed-folk`", &Row::scheme},
      {"blocks", "", "that lie in realisations with two or more", &Row::blocks},
      {"realisations", "", "with two or more blocks", &Row::realisations},
      {"same_share", "", "of blocks whose nearest neighbour (between centres) has the same class",
       &Row::share},
      {"same_expected", "", "where classes are dealt at random to the places of a realisation",
       &Row::expected},
      {"p_value", "",
       "of a share so far from that, from exchanges within realisations; empty below two",
       [](const Row& row) { return row.p_value.value_or(NAN); }}};
  return columns;
}

const TableColumns<SortingTrend>& report_detail::sorting_columns() {
  using Row = SortingTrend;
  static const auto columns = joined<Row>(
      {{{"file", "", "number of the results file",
         [](const Row& row) { return number_of(row.file); }},
        {"property", "", "of the blocks: `volume`, `I/L` or `S/L`", &Row::property},
        {"place", "", "`runout` of runs.csv, or `ahead`, `aside`, `relative height` of fabric.csv",
         &Row::place},
        {"realisations", "", "that have the correlation",
         [](const Row& row) { return row.rank_correlation.summary.count; }}},
       mean_columns<Row>("rank_correlation_*", "", "Spearman's within realisations, mean over them",
                         &Row::rank_correlation),
       {{"p_value", "", "of none on average, two-sided, over realisations; empty below two",
         [](const Row& row) { return row.p_value.value_or(NAN); }}}});
  return columns;
}

std::string fabric_csv(const DepositFabric& fabric) {
  return csv_of(fabric_columns(), fabric.groups);
}

std::string neighbours_csv(const DepositFabric& fabric) {
  return csv_of(neighbour_columns(), fabric.neighbours);
}

std::string sorting_csv(const DepositFabric& fabric) {
  return csv_of(sorting_columns(), fabric.sorting);
}

}  // namespace clast
