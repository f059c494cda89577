// Tables as columns of values hold what their CSV files hold.
#include "report/tables/table_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "report/tables/group_tables.hpp"
#include "report/tables/run_tables.hpp"
#include "tests/study/csv_reader.hpp"
#include "tests/study/hand_made_results.hpp"
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
  expect_same(comparison_table(comparison, "runs"), runs_csv(comparison));
  expect_same(comparison_table(comparison, "crossings"), crossings_csv(comparison));
  expect_same(comparison_table(comparison, "impacts"), impacts_csv(comparison));
  expect_same(comparison_table(comparison, "barriers"), barriers_csv(comparison));
  expect_same(comparison_table(comparison, "deposits"), deposits_csv(comparison));
  expect_same(comparison_table(comparison, "differences"), differences_csv(comparison));
  expect_same(comparison_table(comparison, "effects"), effects_csv(comparison));
  expect_same(comparison_table(comparison, "trends"), trends_csv(comparison));
  expect_same(comparison_table(comparison, "responses"), responses_csv(comparison));
  expect_same(comparison_table(comparison, "ground_sets"), ground_sets_csv(comparison));
}

TEST(TableValues, CountsStayCountsAndTextsTexts) {
  const TableValues runs = comparison_table(compared(hand_made_results()), "runs");
  ASSERT_EQ(runs[0].name, "run");
  EXPECT_TRUE(std::holds_alternative<std::vector<std::uint64_t>>(runs[0].values));
  ASSERT_EQ(runs[1].name, "block");
  EXPECT_TRUE(std::holds_alternative<std::vector<std::string>>(runs[1].values));
  EXPECT_FALSE(runs[0].meaning.empty());
}

TEST(TableValues, EveryNameIsATableAndOthersAreRefused) {
  const Comparison comparison = compared(hand_made_results());
  for (const std::string& name : comparison_table_names()) {
    EXPECT_FALSE(comparison_table(comparison, name).empty()) << name;
  }
  EXPECT_TRUE(contains(refusal([&] { comparison_table(comparison, "colours"); }),
                       "\"colours\" is no table; there are runs, barriers"));
}

}  // namespace
}  // namespace clast
