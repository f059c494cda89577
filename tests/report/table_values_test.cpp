// Tables as columns of values hold what their CSV files hold.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/study/csv_reader.hpp"
#include "tests/study/hand_made_results.hpp"
#include "tests/study/table_csv.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

/// Every value against its cell.
void expect_same(const TableValues& values, const std::string& csv) {
  const CsvTable table = read_csv(csv);
  for (const ColumnValues& column : values) {
    const auto check = [&](const auto& held) {
      ASSERT_EQ(held.size(), table.rows.size()) << column.name;
      for (std::size_t row = 0; row < held.size(); ++row) {
        const std::string& cell = table.rows[row].at(column.name);
        if constexpr (std::is_same_v<std::decay_t<decltype(held[0])>, std::string>) {
          EXPECT_EQ(held[row], cell) << column.name;
        } else if (cell.empty()) {
          EXPECT_TRUE(std::isnan(static_cast<double>(held[row]))) << column.name;
        } else {
          EXPECT_EQ(static_cast<double>(held[row]), table.number(row, column.name)) << column.name;
        }
      }
    };
    std::visit(check, column.values);
  }
}

TEST(TableValues, AreThoseOfTheCsvFiles) {
  const Comparison comparison = compared(hand_made_results());
  ASSERT_GT(comparison.rows.size(), 1u);
  for (const ComparisonTable& table : comparison_tables()) {
    expect_same(table.values(comparison), table.csv(comparison));
  }
}

TEST(TableValues, CountsStayCountsAndTextsTexts) {
  const TableValues runs =
      find_report_table(comparison_tables(), "runs").values(compared(hand_made_results()));
  ASSERT_EQ(runs[0].name, "run");
  EXPECT_TRUE(std::holds_alternative<std::vector<std::uint64_t>>(runs[0].values));
  ASSERT_EQ(runs[1].name, "block");
  EXPECT_TRUE(std::holds_alternative<std::vector<std::string>>(runs[1].values));
  EXPECT_FALSE(runs[0].meaning.empty());
}

TEST(ComparisonTables, OthersAreRefused) {
  EXPECT_TRUE(contains(refusal([] { find_report_table(comparison_tables(), "colours"); }),
                       "\"colours\" is no table; there are runs, crossings"));
}

}  // namespace
}  // namespace clast
