#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
#include "report/tables/comparison_columns.hpp"
#include "report/tables/population_columns.hpp"
#include "study/results/detail/results_layout.hpp"

namespace clast {

using namespace report_detail;
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

template <class Row>
std::string lines_of(const TableColumns<Row>& columns) {
  std::vector<DocumentedColumn> documented;
  for (const TableColumn<Row>& column : columns) {
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

INSTANTIATE_TEST_SUITE_P(
    Csv, TableColumnsOf,
    testing::Values(Table{"runs.csv", lines_of(run_columns())},
                    Table{"barriers.csv", lines_of(barrier_columns())},
                    Table{"crossings.csv", lines_of(crossing_columns())},
                    Table{"deposits.csv", lines_of(deposit_columns())},
                    Table{"impacts.csv", lines_of(impact_columns())},
                    Table{"ground_sets.csv", lines_of(ground_set_columns())},
                    Table{"effects.csv", lines_of(effect_columns())},
                    Table{"trends.csv", lines_of(trend_columns())},
                    Table{"responses.csv", lines_of(response_columns())},
                    Table{"ensemble.csv", lines_of(ensemble_columns())},
                    Table{"stays.csv", lines_of(stay_columns())},
                    Table{"realisations.csv", lines_of(realisation_columns())},
                    Table{"realisation_figures.csv", lines_of(realisation_figure_columns())},
                    Table{"realisation_differences.csv",
                          lines_of(realisation_difference_columns())},
                    Table{"passages.csv", lines_of(passage_columns())},
                    Table{"passage_curves.csv", lines_of(passage_curve_columns())},
                    Table{"energies.csv", lines_of(energy_columns())},
                    Table{"mobility.csv", lines_of(mobility_columns())},
                    Table{"differences.csv", lines_of(difference_columns())},
                    Table{"profiles.csv", lines_of(profile_columns())},
                    Table{"measured.csv", lines_of(measured_columns())},
                    Table{"classes.csv", lines_of(class_columns(scheme_names(), {}))},
                    Table{"shares.csv", lines_of(share_columns())},
                    Table{"sizes.csv", lines_of(size_columns())},
                    Table{"tests.csv", lines_of(test_columns())}));

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
                                         Table{"stays", datasets_of<StayRecord>("stays")},
                                         Table{"energies", datasets_of<EnergyRecord>("energies")}));

}  // namespace
}  // namespace clast
