#pragma once
/// Columns and rows of the tables of a comparison.
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "report/tables/comparison_tables.hpp"
#include "study/compare/run_columns.hpp"

namespace clast::report_detail {

/// Returns the columns of the table of barrier statistics.
const TableColumns<BarrierGroupStatistics>& barrier_table_columns();
const TableColumns<ComparisonRow<BarrierCrossing>>& crossing_columns();

/// Makes the tables of the runs of a comparison.
std::vector<ComparisonTable> make_run_tables();
std::vector<ComparisonTable> make_group_tables();
std::vector<ComparisonTable> make_effect_tables();
std::vector<ComparisonTable> make_crossing_tables();
std::vector<ComparisonTable> make_deposit_tables();
std::vector<ComparisonTable> make_energy_tables();

/// Returns lower and upper end of an interval; NaN if there is no interval.
inline Vec2 interval_bounds(const std::optional<Interval>& interval) {
  return interval ? Vec2(interval->low, interval->high) : Vec2(Vec2::Constant(NAN));
}

/// Makes table rows from a list of items.
template <class Item>
std::vector<ComparisonRow<Item>> make_comparison_rows(const Comparison& comparison,
                                                      const std::vector<Item>& items) {
  std::vector<ComparisonRow<Item>> rows;
  for (const Item& item : items) rows.push_back({comparison, item});
  return rows;
}

template <class Row>
const std::vector<Row>& select_rows(const TableColumns<Row>&, const Comparison&,
                                    const std::vector<Row>& rows) {
  return rows;
}
template <class Item>
std::vector<ComparisonRow<Item>> select_rows(const TableColumns<ComparisonRow<Item>>&,
                                             const Comparison& comparison,
                                             const std::vector<Item>& items) {
  return make_comparison_rows(comparison, items);
}

/// Makes a table of a comparison from its columns and a function that gives its rows.
/// @param columns  must outlive the table
/// @param items  function that returns one item per row from the analyses or the comparison
template <class Row, class Items>
ComparisonTable make_comparison_table(const std::string& name, const TableColumns<Row>& columns,
                                      const Items& items) {
  const auto filled = [&columns, items](const auto& fill) {
    return [&columns, items, fill](const ComparisonAnalyses& of) {
      if constexpr (std::is_invocable_v<const Items&, const ComparisonAnalyses&>) {
        return fill(columns, select_rows(columns, of.comparison(), std::invoke(items, of)));
      } else {
        return fill(columns,
                    select_rows(columns, of.comparison(), std::invoke(items, of.comparison())));
      }
    };
  };
  return {name, filled(format_csv<Row>), filled(to_table_values<Row>)};
}

}  // namespace clast::report_detail
