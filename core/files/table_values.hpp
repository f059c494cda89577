#pragma once
/// Tables as columns of plain values, for arrays in Python.
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/files/table.hpp"

namespace clast {

/// Values of one table column, all of the same type. Unknown numbers are NaN.
struct ColumnValues {
  std::string name;     ///< with unit: "speed_m_s"
  std::string unit;     ///< "m/s"; empty if there is none
  std::string meaning;  ///< Markdown
  std::variant<std::vector<std::uint64_t>, std::vector<double>, std::vector<std::string>> values;
};

using TableValues = std::vector<ColumnValues>;

namespace core_detail {

/// Converts the cells of a column to their narrowest common type; doubles if there are no rows.
inline auto typed_values(const std::vector<TableCell>& cells) {
  decltype(ColumnValues::values) values = std::vector<double>();
  const auto any = [&]<class T>(T) {
    for (const TableCell& cell : cells) {
      if (std::holds_alternative<T>(cell)) return true;
    }
    return false;
  };
  if (any(std::string())) {
    std::vector<std::string>& texts = values.emplace<std::vector<std::string>>();
    for (const TableCell& cell : cells) texts.push_back(std::get<std::string>(cell));
  } else if (cells.empty() || any(0.0)) {
    std::vector<double>& numbers = std::get<std::vector<double>>(values);
    for (const TableCell& cell : cells) {
      const auto* count = std::get_if<std::uint64_t>(&cell);
      numbers.push_back(count ? static_cast<double>(*count) : std::get<double>(cell));
    }
  } else {
    std::vector<std::uint64_t>& counts = values.emplace<std::vector<std::uint64_t>>();
    for (const TableCell& cell : cells) counts.push_back(std::get<std::uint64_t>(cell));
  }
  return values;
}

}  // namespace core_detail

/// Converts a whole table to columns of values.
template <class Row>
TableValues to_table_values(const TableColumns<Row>& columns, const std::vector<Row>& rows) {
  TableValues table;
  for (const TableColumn<Row>& column : columns) {
    std::vector<TableCell> cells;
    cells.reserve(rows.size());
    for (const Row& row : rows) cells.push_back(column.value(row));
    table.push_back({column.name, column.unit, column.meaning, core_detail::typed_values(cells)});
  }
  return table;
}

}  // namespace clast
