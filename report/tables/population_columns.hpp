#pragma once
/// The columns of the tables of `clast classify`, each declared once. A test compares them with
/// docs/formats.md.
#include <optional>
#include <string>
#include <vector>

#include "core/files/table.hpp"
#include "report/reported_population.hpp"

namespace clast::report_detail {

struct BlockRow {
  const std::string& population;
  const MeasuredBlock& block;
};
struct ShareRow {
  const std::string& population;
  const std::string& scheme;
  const ClassShare& share;
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
  std::optional<std::size_t> freedom;
  std::optional<double> p_value;
  std::string p_from, words;
};

/// @param schemes  whose classes are listed
TableColumns<BlockRow> class_columns(const std::vector<std::string>& schemes,
                                     const SchemeOptions& limits);
const TableColumns<ShareRow>& share_columns();
const TableColumns<SizeRow>& size_columns();
const TableColumns<TestRow>& test_columns();

/// The rows; those of shares refer to the report.
std::vector<ShareRow> share_rows(const PopulationReport& report);
std::vector<SizeRow> size_rows(const PopulationReport& report);
std::vector<TestRow> test_rows(const PopulationReport& report);

}  // namespace clast::report_detail
