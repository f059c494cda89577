#include "report/tables/population_tables.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/error.hpp"
#include "core/files/output_file.hpp"
#include "core/files/table.hpp"
#include "core/parallel.hpp"
#include "report/tables/scanned_deposit_tables.hpp"

namespace clast {

namespace {

struct BlockRow {
  const std::string& population;
  const MeasuredBlock& block;
};
struct ShareRow {
  const std::string& population;
  const std::string& scheme;
  const ClassFraction& share;
  bool weighed = false;  ///< the mass of some block is known
};
/// A quantity of a size distribution.
struct SizeRow {
  std::string population, size, weighting;
  std::size_t blocks = 0;
  std::string quantity = {}, unit = {};
  double value = 0.0;
  std::optional<double> error = {};
};
struct TestRow {
  std::string test, populations, quantity;
  std::optional<double> statistic;
  std::optional<std::size_t> degrees_of_freedom;
  std::optional<double> p_value;
  std::string p_from, words;
};

/// An empty cell for what is not known.
template <class T>
TableCell cell_of(const std::optional<T>& value) {
  return value ? TableCell(*value) : TableCell(NAN);
}

std::vector<SizeRow> rows_of_curve(const SizeRow& common, const SizeCurve& curve) {
  if (curve.blocks == 0) return {};  // every block is unscaled
  std::vector<SizeRow> rows;
  const auto add = [&](const std::string& name, const char* unit, double value,
                       std::optional<double> error = {}) {
    rows.push_back(common);
    SizeRow& row = rows.back();
    row.blocks = curve.blocks;
    row.quantity = name;
    row.unit = unit;
    row.value = value;
    row.error = error;
  };
  add("d10", "m", curve.d10);
  add("d50", "m", curve.d50);
  add("d90", "m", curve.d90);
  for (const FittedSizeLaw& law : curve.laws) {
    const bool normal = law.kind == SizeLawKind::kLogNormal;
    const std::string name = normal ? "log_normal_" : "rosin_rammler_";
    add(name + (normal ? "median" : "d63"), "m", law.location, law.location_error);
    add(name + (normal ? "sigma" : "exponent"), "", law.spread, law.spread_error);
    add(name + "ks_distance", "", law.distance);
    if (law.p_value) add(name + "ks_p_value", "", *law.p_value);
  }
  return rows;
}

TestRow row_of(const std::string& kind, const std::string& populations, const std::string& quantity,
               const std::optional<TestResult>& test, const char* exact, const char* limit,
               const std::string& words) {
  if (!test) return {kind, populations, quantity, {}, {}, {}, "", words};
  return {
      kind, populations, quantity, test->statistic, {}, test->p_value, test->exact ? exact : limit,
      words};
}

TestRow row_of(const std::string& populations, const ClassFractionDifference& one) {
  const std::string kind = "chi-squared";
  if (!one.test) return {kind, populations, one.scheme, {}, {}, {}, "", one.description};
  const ChiSquaredResult& test = *one.test;
  const std::string from = test.draws > 0 ? std::to_string(test.draws) + " random tables"
                                          : std::string("chi-squared distribution");
  return {kind,         populations, one.scheme,     test.chi_squared, test.degrees_of_freedom,
          test.p_value, from,        one.description};
}

TableColumns<BlockRow> class_columns(const PopulationOptions& options) {
  using Row = BlockRow;
  const auto axis = [](const char* name, double Axes::*side) {
    return TableColumn<Row>{name, "m", "axes, L >= I >= S", [side](const Row& row) {
                              return row.block.unscaled ? NAN : row.block.axes.*side;
                            }};
  };
  TableColumns<Row> columns = {
      {"population", "", "names", [](const Row& row) { return row.population; }},
      {"block", "", "names", [](const Row& row) { return row.block.name; }},
      axis("L_m", &Axes::L),
      axis("I_m", &Axes::I),
      axis("S_m", &Axes::S),
      {"mass_kg", "kg", "weighed, or volume times density for blocks of a library",
       [](const Row& row) { return row.block.unscaled ? NAN : row.block.mass.value_or(NAN); }},
      {"axis_error_m", "m", "possible error of each axis, as given or assumed",
       [](const Row& row) { return row.block.unscaled ? NAN : row.block.axis_error; }}};
  for (const std::string& scheme : options.selected_schemes()) {
    columns.push_back({class_column_name(scheme), "",
                       "class by each requested scheme; `shape` is Garcia's `compact` or "
                       "`elongated`",
                       [scheme, limits = options.limits](const Row& row) {
                         return shape_class(scheme, row.block.axes_in_table_unit, limits);
                       }});
  }
  for (const FormIndex& index : form_index_definitions()) {
    columns.push_back(
        {index.name, "", "indices of form, see [theory](theory/shape-classes.md#indices-of-form)",
         [index](const Row& row) { return cell_of(index.value(row.block.axes_in_table_unit)); }});
  }
  return columns;
}

TableColumns<ShareRow> share_columns(const PopulationOptions&) {
  using Row = ShareRow;
  const auto number = [](const char* name, double ClassFraction::*value) {
    return TableColumn<Row>{name, "", "fraction by number, with its 95 % confidence interval",
                            [value](const Row& row) { return row.share.*value; }};
  };
  const auto mass = [](const char* name, const char* unit, const char* meaning,
                       double ClassFraction::*value) {
    return TableColumn<Row>{name, unit, meaning, [value](const Row& row) {
                              return row.weighed ? row.share.*value : NAN;
                            }};
  };
  const char* by_mass =
      "fraction by mass, with its 95 % confidence interval; empty if no mass "
      "is known";
  return {{"population", "", "names", [](const Row& row) { return row.population; }},
          {"scheme", "", "names", [](const Row& row) { return row.scheme; }},
          {"class", "", "name of the class; classes without a block have a row too",
           [](const Row& row) { return row.share.name; }},
          {"blocks", "", "number of blocks in the class",
           [](const Row& row) { return row.share.count; }},
          number("share", &ClassFraction::fraction),
          number("share_low", &ClassFraction::low),
          number("share_high", &ClassFraction::high),
          mass("mass_kg", "kg", "mass of the blocks of the class whose mass is known",
               &ClassFraction::mass),
          mass("mass_share", "", by_mass, &ClassFraction::mass_fraction),
          mass("mass_share_low", "", by_mass, &ClassFraction::mass_low),
          mass("mass_share_high", "", by_mass, &ClassFraction::mass_high)};
}

TableColumns<SizeRow> size_columns(const PopulationOptions&) {
  using Row = SizeRow;
  return {{"population", "", "name of the population", &Row::population},
          {"size", "", "measure of size: `I` or `(L I S)^(1/3)`", &Row::size},
          {"weighting", "", "weighting: by `number` or by `mass`", &Row::weighting},
          {"blocks", "", "number of blocks from which the quantity is computed", &Row::blocks},
          {"quantity", "",
           "`d10`, `d50`, `d90`; `log_normal_median`, `log_normal_sigma` (of ln d); "
           "`rosin_rammler_d63`, `rosin_rammler_exponent`; for each law `..._ks_distance` and, by "
           "number, `..._ks_p_value`",
           &Row::quantity},
          {"unit", "", "unit of the value: `m`, or empty", &Row::unit},
          {"value", "see `unit`", "value of the quantity", &Row::value},
          {"standard_error", "see `unit`", "standard error, for fitted parameters only",
           [](const Row& row) { return cell_of(row.error); }}};
}

TableColumns<TestRow> test_columns(const PopulationOptions&) {
  using Row = TestRow;
  const char* tested =
      "name of the tested population, or two names with `and`; the tested "
      "measures or scheme";
  return {{"test", "", "`spearman`, `kolmogorov-smirnov`, `chi-squared`", &Row::test},
          {"populations", "", tested, &Row::populations},
          {"quantity", "", tested, &Row::quantity},
          {"statistic", "", "rho, D or chi-squared",
           [](const Row& row) { return cell_of(row.statistic); }},
          {"degrees_of_freedom", "", "degrees of freedom of chi-squared",
           [](const Row& row) { return cell_of(row.degrees_of_freedom); }},
          {"p_value", "", "probability of a statistic at least this extreme if there is no effect",
           [](const Row& row) { return cell_of(row.p_value); }},
          {"p_from", "", "method by which the p-value was determined", &Row::p_from},
          {"words", "", "a sentence to quote", &Row::words}};
}

std::vector<ShareRow> share_rows(const PopulationReport& report) {
  std::vector<ShareRow> rows;
  for (const ReportedPopulation& reported : report.populations) {
    const bool weighed = reported.summary.blocks_with_mass > 0;
    for (const SchemeFractions& scheme : reported.summary.schemes) {
      for (const ClassFraction& share : scheme.fractions) {
        rows.push_back({reported.population.name, scheme.scheme, share, weighed});
      }
    }
  }
  return rows;
}

std::vector<SizeRow> size_rows(const PopulationReport& report) {
  std::vector<SizeRow> rows;
  for (const ReportedPopulation& reported : report.populations) {
    const SizeDistribution& size = reported.summary.size;
    const auto add = [&](const char* weighting, const SizeCurve& curve) {
      const std::vector<SizeRow> more =
          rows_of_curve({reported.population.name, name_of(size.measure), weighting}, curve);
      rows.insert(rows.end(), more.begin(), more.end());
    };
    add("number", size.by_number);
    if (size.by_mass) add("mass", *size.by_mass);
  }
  return rows;
}

std::vector<TestRow> test_rows(const PopulationReport& report) {
  std::vector<TestRow> rows;
  for (const ReportedPopulation& reported : report.populations) {
    for (const SizeShapeCorrelation& one : reported.summary.size_shape_correlations) {
      rows.push_back(row_of("spearman", reported.population.name,
                            name_of(report.options.size) + " and " + one.measure->name, one.test,
                            "all orders", "Student's t",
                            describe_size_shape(one, report.options.size)));
    }
  }
  if (report.comparison) {
    const std::string pair = report.comparison->name_a + " and " + report.comparison->name_b;
    for (const ShapeMeasureDifference& one : report.comparison->measures) {
      rows.push_back(row_of("kolmogorov-smirnov", pair, one.measure->name, one.test, "all deals",
                            "limit for many blocks", one.description));
    }
    for (const ClassFractionDifference& one : report.comparison->schemes) {
      rows.push_back(row_of(pair, one));
    }
  }
  return rows;
}

std::vector<BlockRow> block_rows(const PopulationReport& report) {
  std::vector<BlockRow> rows;
  for (const ReportedPopulation& reported : report.populations) {
    for (const MeasuredBlock& block : reported.population.blocks) {
      rows.push_back({reported.population.name, block});
    }
  }
  return rows;
}

/// @param columns  of a report's options
template <class Row>
PopulationTable population_table(const std::string& name,
                                 TableColumns<Row> (*columns)(const PopulationOptions&),
                                 std::vector<Row> (*rows)(const PopulationReport&)) {
  const auto filled = [=](const auto& fill) {
    return
        [=](const PopulationReport& report) { return fill(columns(report.options), rows(report)); };
  };
  return {name, filled(format_csv<Row>), filled(to_table_values<Row>)};
}

}  // namespace

std::string class_column_name(const std::string& scheme) {
  if (scheme == "garcia") return "shape";
  std::string column = scheme;
  std::replace(column.begin(), column.end(), '-', '_');
  return column;
}

void write_classes_csv(const PopulationReport& report, const std::filesystem::path& path,
                       unsigned threads) {
  constexpr std::size_t kChunk = 2048;   // rows of one task
  constexpr std::size_t kTogether = 32;  // tasks in memory at a time, some 20 MB
  const TableColumns<BlockRow> columns = class_columns(report.options);
  OutputFile file(path);
  std::ofstream stream(file.temporary_path(), std::ios::binary);
  stream << csv_header(columns) << "\n";
  for (const ReportedPopulation& reported : report.populations) {
    const std::vector<MeasuredBlock>& blocks = reported.population.blocks;
    for (std::size_t first = 0; first < blocks.size(); first += kChunk * kTogether) {
      const std::size_t last = std::min(first + kChunk * kTogether, blocks.size());
      std::vector<std::string> chunks((last - first + kChunk - 1) / kChunk);
      parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
        CsvWriter csv;
        const std::size_t begin = first + chunk * kChunk;
        for (std::size_t i = begin; i < std::min(begin + kChunk, last); ++i) {
          append_csv_row(csv, columns, {reported.population.name, blocks[i]});
        }
        chunks[chunk] = csv.take_text();
      });
      for (const std::string& chunk : chunks) stream << chunk;
    }
  }
  stream.close();
  if (!stream) throw InputError(path.string() + ": writing failed; is the disk full?");
  file.commit();
}

const std::vector<PopulationTable>& population_tables() {
  static const std::vector<PopulationTable> tables = [] {
    std::vector<PopulationTable> all = {population_table("classes", class_columns, block_rows),
                                        population_table("shares", share_columns, share_rows),
                                        population_table("sizes", size_columns, size_rows),
                                        population_table("tests", test_columns, test_rows)};
    const std::vector<PopulationTable>& scanned = scanned_deposit_tables();
    all.insert(all.end(), scanned.begin(), scanned.end());
    return all;
  }();
  return tables;
}

}  // namespace clast
