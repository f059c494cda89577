#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
#include "particles/particle_export.hpp"
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
  std::string about;  ///< after the names: " (m): height above ground"
};

std::string describe(const std::vector<std::string>& properties, const std::string& meaning) {
  std::string text;
  for (const std::string& property : properties) {
    if (!property.empty()) text += (text.empty() ? " (" : "; ") + property;
  }
  return text + (text.empty() ? ": " : "): ") + meaning;
}

/// Splits a text where a line may end: not in code, and not before a sign that would begin a list.
std::vector<std::string> split_words(const std::string& text) {
  std::vector<std::string> words(1);
  bool code = false;
  for (const char c : text) {
    if (c == '`') code = !code;
    if (c == ' ' && !code)
      words.emplace_back();
    else
      words.back() += c;
  }
  for (std::size_t i = 1; i < words.size();) {
    if (words[i].size() == 1 && std::string("-+*#>|").find(words[i][0]) != std::string::npos) {
      words[i - 1] += " " + words[i];
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  return words;
}

/// An item of a list, in lines of up to 110 characters.
std::string wrap_item(const std::string& text) {
  std::string lines;
  std::string line = "-";
  for (const std::string& word : split_words(text)) {
    if (line.size() + 1 + word.size() > 110) {
      lines += line + "\n";
      line = " ";
    }
    line += " " + word;
  }
  return lines + line + "\n";
}

/// An item for all neighbours that share unit and meaning.
std::string lines_of(const std::vector<DocumentedColumn>& columns) {
  std::string lines;
  std::string names;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    names += (names.empty() ? "`" : ", `") + columns[i].name + "`";
    if (i + 1 < columns.size() && columns[i].about == columns[i + 1].about) continue;
    lines += wrap_item(names + columns[i].about);
    names.clear();
  }
  return lines;
}

std::string lines_of(const TableValues& columns) {
  std::vector<DocumentedColumn> documented;
  for (const ColumnValues& column : columns) {
    documented.push_back({column.name, describe({column.unit}, column.meaning)});
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
  visit_columns(kRowType<Row>, [&](const std::string& name, const std::string& unit,
                                   const std::string& meaning, const auto& field) {
    const std::string type = type_of(StoredType<Row, decltype(field)>());
    const std::string about = describe({type + " [" + group + "]", unit}, meaning);
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
  const std::size_t section = docs.find("### " + GetParam().file);
  ASSERT_NE(section, std::string::npos);
  const std::size_t begin = docs.find("\n- `", section) + 1;
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
  std::vector<DocumentedColumn> particles;
  for (const TableColumn<ParticleRecord>& column : particle_columns()) {
    particles.push_back({column.name, describe({column.unit}, column.meaning)});
  }
  tables.push_back({"particles.csv", lines_of(particles)});
  return tables;
}

INSTANTIATE_TEST_SUITE_P(Csv, TableColumnsOf, testing::ValuesIn(csv_tables()));

class ResultsColumnsOf : public testing::TestWithParam<Table> {};

TEST_P(ResultsColumnsOf, AreThoseOfTheDocument) {
  const std::string docs = formats();
  const std::string& lines = GetParam().lines;
  const std::size_t begin = docs.find(lines.substr(0, lines.find(' ', 2)));
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(docs.substr(begin, lines.size()), lines);
}

INSTANTIATE_TEST_SUITE_P(Hdf5, ResultsColumnsOf,
                         testing::Values(Table{"runs", datasets_of<RunRecord>("runs")},
                                         Table{"impacts", datasets_of<Impact>("impacts")},
                                         Table{"crossings", datasets_of<Crossing>("crossings")},
                                         Table{"stays",
                                               datasets_of<PersistentBlockRecord>("stays")},
                                         Table{"energies", datasets_of<EnergyRecord>("energies")}));

}  // namespace
}  // namespace clast
