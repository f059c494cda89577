#pragma once
/// Columns of runs.csv, and groups of runs by column values.
#include <string>

#include "core/files/table.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// Row of a comparison table: an item together with the comparison that contains it.
template <class Item>
struct ComparisonRow {
  const Comparison& comparison;
  const Item& item;

  const Item& operator*() const { return item; }
  const Item* operator->() const { return &item; }
};

/// Returns the columns of runs.csv in their order.
const TableColumns<ComparisonRow<RunRow>>& run_columns();

/// Adds one group of runs per value of a column. Numeric columns with more than `kMaxColumnGroups`
/// values are divided at their quartiles.
/// @throws InputError  if the column does not exist; the message lists the columns
void append_column_groups(Comparison& comparison, const std::string& column);

/// Maximum number of groups of a numeric column.
inline constexpr std::size_t kMaxColumnGroups = 8;

}  // namespace clast
