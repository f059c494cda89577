#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
#include "report/tables/comparison_tables.hpp"
#include "report/tables/population_tables.hpp"
#include "study/results/detail/results_layout.hpp"
#include "tests/study/hand_made_results.hpp"

namespace clast {

using namespace study_detail;
namespace {

/// A column as docs/formats.md has it.
struct DocumentedColumn {
  std::string name;
  std::string about;  ///< the cells after the name: "m | height above ground |"
};

std::string cell(const std::string& text) { return text.empty() ? "| " : "| " + text + " "; }

/// A line for all neighbours that share unit and meaning.
std::string lines_of(const std::vector<DocumentedColumn>& columns) {
  std::string lines;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool begins = i == 0 || columns[i].about != columns[i - 1].about;
    const bool ends = i + 1 == columns.size() || columns[i].about != columns[i + 1].about;
    lines += (begins ? "| `" : ", `") + columns[i].name + "`";
    if (ends) lines += " " + columns[i].about + "|\n";
  }
  return lines;
}

std::string lines_of(const TableValues& columns) {
  std::vector<DocumentedColumn> documented;
  for (const ColumnValues& column : columns) {
    documented.push_back({column.name, cell(column.unit) + cell(column.meaning)});
  }
  return lines_of(documented);
}

const char* type_of(std::uint8_t) { return "uint8"; }
const char* type_of(std::uint32_t) { return "uint32"; }
const char* type_of(std::int64_t) { return "int64"; }
const char* type_of(double) { return "double"; }
const char* type_of(const std::string&) { return "text"; }

/// The datasets of a group of a results file.
template <class Row>
std::string datasets_of(const std::string& group) {
  std::vector<DocumentedColumn> documented;
  visit_columns(kRowsOf<Row>, [&](const std::string& name, const std::string& unit,
                                  const std::string& meaning, const auto& field) {
    const std::string type = type_of(Stored<Row, decltype(field)>());
    const std::string about = cell(type + " [" + group + "]") + cell(unit) + cell(meaning);
    const bool begins = documented.empty() || documented.back().about != about;
    documented.push_back({(begins ? "/" + group + "/" : "") + name, about});
  });
  return lines_of(documented);
}

std::string formats() {
  return read_text_file(std::filesystem::path(CLAST_SOURCE_DIR) / "docs" / "formats.md");
}

struct Table {
  std::string file;
  std::string lines;
};
void PrintTo(const Table& table, std::ostream* out) { *out << table.file; }

class TableColumnsOf : public testing::TestWithParam<Table> {};

TEST_P(TableColumnsOf, AreThoseOfTheDocument) {
  const std::string docs = formats();
  const std::string head = "| column | unit | meaning |\n|---|---|---|\n";
  const std::size_t section = docs.find("### " + GetParam().file);
  ASSERT_NE(section, std::string::npos);
  const std::size_t begin = docs.find(head, section) + head.size();
  EXPECT_EQ(docs.substr(begin, docs.find("\n\n", begin) + 1 - begin), GetParam().lines);
}

std::vector<Table> csv_tables() {
  std::vector<Table> tables;
  const Comparison comparison = compared(hand_made_results());
  for (const ComparisonTable& table : comparison_tables()) {
    tables.push_back({table.name + ".csv", lines_of(table.values(comparison))});
  }
  PopulationReport report;
  report.options.schemes = scheme_names();
  for (const PopulationTable& table : population_tables()) {
    tables.push_back({table.name + ".csv", lines_of(table.values(report))});
  }
  return tables;
}

INSTANTIATE_TEST_SUITE_P(Csv, TableColumnsOf, testing::ValuesIn(csv_tables()));

class ResultsColumnsOf : public testing::TestWithParam<Table> {};

TEST_P(ResultsColumnsOf, AreThoseOfTheDocument) {
  const std::string docs = formats();
  const std::string& lines = GetParam().lines;
  const std::size_t begin = docs.find(lines.substr(0, lines.find('|', 2)));
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(docs.substr(begin, lines.size()), lines);
}

INSTANTIATE_TEST_SUITE_P(Hdf5, ResultsColumnsOf,
                         testing::Values(Table{"runs", datasets_of<RunRecord>("runs")},
                                         Table{"impacts", datasets_of<Impact>("impacts")},
                                         Table{"crossings", datasets_of<Crossing>("crossings")},
                                         Table{"stays", datasets_of<PersistentBlockRecord>("stays")},
                                         Table{"energies", datasets_of<EnergyRecord>("energies")}));

}  // namespace
}  // namespace clast
