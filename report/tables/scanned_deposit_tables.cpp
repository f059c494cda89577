#include "report/tables/scanned_deposit_tables.hpp"

#include <array>

#include "classify/axis_orientation.hpp"
#include "core/angle.hpp"
#include "core/files/table.hpp"

namespace clast {
namespace {

struct ScannedBlockRow {
  const std::string& population;
  const MeasuredBlock& block;
  const DepositObservation& seen;
  AxisOrientation long_axis;
  double inclusion_probability = 0.0;
};
struct ScannedSizeRow {
  const std::string& population;
  std::string weighting, quantity, percentile, unit;
  EstimatedValue estimate;
};
struct ScannedShareRow {
  const std::string& population;
  const std::string& scheme;
  const CorrectedFraction& fraction;
};

const TableColumns<ScannedBlockRow>& scanned_block_columns() {
  using Row = ScannedBlockRow;
  static const auto columns = concatenated_columns<Row>(
      {{{"population", "", "names", [](const Row& row) { return row.population; }},
        {"block", "", "names", [](const Row& row) { return row.block.name; }},
        {"points", "", "number of its points",
         [](const Row& row) { return std::uint64_t{row.seen.points}; }},
        {"visible_fraction", "", "observed area over the area of the body",
         [](const Row& row) { return row.seen.visible_fraction; }},
        {"confidence", "", "probability that its outline is that of one block",
         [](const Row& row) { return row.seen.confidence; }}},
       array_columns<Row>({"L_low90_m", "I_low90_m", "S_low90_m"}, "m",
                          "lower limits of the two-sided 90 % intervals",
                          [](const Row& row) {
                            const Axes& axes = row.seen.lower_axes;
                            return std::array{axes.L, axes.I, axes.S};
                          }),
       array_columns<Row>({"L_high90_m", "I_high90_m", "S_high90_m"}, "m",
                          "upper limits of the two-sided 90 % intervals",
                          [](const Row& row) {
                            const Axes& axes = row.seen.upper_axes;
                            return std::array{axes.L, axes.I, axes.S};
                          }),
       {{"volume_m3", "m3", "volume", [](const Row& row) { return row.seen.volume; }},
        {"plan_area_m2", "m2", "area of the body in plan",
         [](const Row& row) { return row.seen.plan_area; }},
        {"exposed_area_m2", "m2", "part of it above which there is no other block",
         [](const Row& row) { return row.seen.exposed_area; }},
        {"trend_deg", "deg", "direction of the lower end of its long axis, clockwise from +y",
         [](const Row& row) { return row.long_axis.trend * kDegreesPerRadian; }},
        {"plunge_deg", "deg", "angle of its long axis below the horizontal",
         [](const Row& row) { return row.long_axis.plunge * kDegreesPerRadian; }},
        {"found_probability", "", "probability that a block of this size is found",
         [](const Row& row) { return row.inclusion_probability; }}}});
  return columns;
}

const TableColumns<ScannedSizeRow>& scanned_size_columns() {
  using Row = ScannedSizeRow;
  static const TableColumns<Row> columns = {
      {"population", "", "name of the population", [](const Row& row) { return row.population; }},
      {"weighting", "",
       "weight of each found block: `number` (1), `area` (its area in plan), `grid` (its exposed "
       "area, as points of a grid hit blocks), `corrected` (number of blocks of the deposit for "
       "which it stands)",
       &Row::weighting},
      {"quantity", "", "size: `L`, `I`, `S` or `volume`", &Row::quantity},
      {"percentile", "", "`D16`, `D50`, `D84` or `P95`", &Row::percentile},
      {"unit", "", "unit of the value: `m` or `m3`", &Row::unit},
      {"value", "see `unit`", "value of the percentile",
       [](const Row& row) { return row.estimate.value; }},
      {"low", "see `unit`", "limits of its 95 % interval",
       [](const Row& row) { return row.estimate.interval.low; }},
      {"high", "see `unit`", "limits of its 95 % interval",
       [](const Row& row) { return row.estimate.interval.high; }}};
  return columns;
}

const TableColumns<ScannedShareRow>& scanned_share_columns() {
  using Row = ScannedShareRow;
  const char* found =
      "fraction of the blocks that show, with its 95 % interval; each block counts in all its "
      "possible classes";
  const char* corrected = "fraction of all blocks of the deposit, with its 95 % interval";
  static const TableColumns<Row> columns = {
      {"population", "", "names", [](const Row& row) { return row.population; }},
      {"scheme", "", "names", [](const Row& row) { return row.scheme; }},
      {"class", "", "name of the class", [](const Row& row) { return row.fraction.name; }},
      {"share", "", found, [](const Row& row) { return row.fraction.found.value; }},
      {"share_low", "", found, [](const Row& row) { return row.fraction.found.interval.low; }},
      {"share_high", "", found, [](const Row& row) { return row.fraction.found.interval.high; }},
      {"corrected_share", "", corrected,
       [](const Row& row) { return row.fraction.corrected.value; }},
      {"corrected_share_low", "", corrected,
       [](const Row& row) { return row.fraction.corrected.interval.low; }},
      {"corrected_share_high", "", corrected,
       [](const Row& row) { return row.fraction.corrected.interval.high; }}};
  return columns;
}

std::vector<ScannedBlockRow> scanned_block_rows(const PopulationReport& report) {
  std::vector<ScannedBlockRow> rows;
  for (const ReportedPopulation& reported : report.populations) {
    if (!reported.deposit) continue;
    for (const MeasuredBlock& block : reported.population.blocks) {
      if (!block.deposit || block.unscaled) continue;
      rows.push_back({reported.population.name, block, *block.deposit,
                      axis_orientation(block.deposit->long_axis),
                      reported.deposit->correction.inclusion_probability(block.axes.I)});
    }
  }
  return rows;
}

std::vector<ScannedSizeRow> scanned_size_rows(const PopulationReport& report) {
  std::vector<ScannedSizeRow> rows;
  for (const ReportedPopulation& reported : report.populations) {
    if (!reported.deposit) continue;
    for (const WeightedSizes& sizes : reported.deposit->sizes) {
      for (std::size_t q = 0; q < kWeightedQuantities.size(); ++q) {
        const std::string quantity = kWeightedQuantities[q];
        for (std::size_t p = 0; p < kWeightedPercentiles.size(); ++p) {
          rows.push_back({reported.population.name, name_of(sizes.weighting), quantity,
                          kWeightedPercentileNames[p], quantity == "volume" ? "m3" : "m",
                          sizes.percentiles[q][p]});
        }
      }
    }
  }
  return rows;
}

std::vector<ScannedShareRow> scanned_share_rows(const PopulationReport& report) {
  std::vector<ScannedShareRow> rows;
  for (const ReportedPopulation& reported : report.populations) {
    if (!reported.deposit) continue;
    for (const CorrectedSchemeFractions& scheme : reported.deposit->schemes) {
      for (const CorrectedFraction& fraction : scheme.fractions) {
        rows.push_back({reported.population.name, scheme.scheme, fraction});
      }
    }
  }
  return rows;
}

template <class Row>
PopulationTable scanned_table(const std::string& name, const TableColumns<Row>& (*columns)(),
                              std::vector<Row> (*rows)(const PopulationReport&)) {
  return {name, [=](const PopulationReport& report) { return format_csv(columns(), rows(report)); },
          [=](const PopulationReport& report) { return to_table_values(columns(), rows(report)); }};
}

}  // namespace

const std::vector<PopulationTable>& scanned_deposit_tables() {
  static const std::vector<PopulationTable> tables = {
      scanned_table("scanned_blocks", scanned_block_columns, scanned_block_rows),
      scanned_table("scanned_shares", scanned_share_columns, scanned_share_rows),
      scanned_table("scanned_sizes", scanned_size_columns, scanned_size_rows)};
  return tables;
}

}  // namespace clast
