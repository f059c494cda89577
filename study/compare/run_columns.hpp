#pragma once
/// The columns of the table of runs, and groups of runs by their values.
#include <string>

#include "core/files/table.hpp"
#include "study/compare/comparison.hpp"

namespace clast {

/// A row of a table of a comparison: it points to an item, and knows the comparison around it.
template <class Item>
struct ComparisonRow {
  const Comparison& comparison;
  const Item& item;

  const Item& operator*() const { return item; }
  const Item* operator->() const { return &item; }
};

/// In the order of runs.csv.
const TableColumns<ComparisonRow<RunRow>>& run_columns();

/// Adds a group for every value of a column, over all files, in rising order; numbers with more
/// than `kMostValues` values are divided at their quartiles: "mass_kg 120 to 250".
/// @throws InputError  no such column; the message lists them
void append_column_groups(Comparison& comparison, const std::string& column);

inline constexpr std::size_t kMostValues = 8;

}  // namespace clast
