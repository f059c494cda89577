#pragma once
/// Tables whose columns are declared once. The declaration serves CSV files, map layers and groups
/// of rows. A test compares it with docs/formats.md.
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/files/csv_writer.hpp"

namespace clast {

/// Cell value: a count, a number or a text. Unknown numbers are not finite.
using TableCell = std::variant<std::uint64_t, double, std::string>;

template <class Row>
struct TableColumn {
  std::string name;     ///< with unit: "speed_m_s"
  std::string unit;     ///< "m/s"; empty if there is none
  std::string meaning;  ///< description in Markdown; adjacent columns with equal ones share a line
  std::function<TableCell(const Row&)> value;
};

template <class Row>
using TableColumns = std::vector<TableColumn<Row>>;

/// Finds a column by name.
/// @throws std::out_of_range  if there is none, which is a programming error
template <class Row>
const TableColumn<Row>& find_column(const TableColumns<Row>& columns, const std::string& name) {
  for (const TableColumn<Row>& column : columns) {
    if (column.name == name) return column;
  }
  throw std::out_of_range("no column " + name);
}

/// Returns the columns with the given names, in the order of the names.
template <class Row>
TableColumns<Row> selected_columns(const TableColumns<Row>& columns,
                                   const std::vector<std::string>& names) {
  TableColumns<Row> result;
  for (const std::string& name : names) result.push_back(find_column(columns, name));
  return result;
}

/// Returns columns for rows that contain a row of another type. `part(row)` returns that row.
template <class Row, class PartRow, class Part>
TableColumns<Row> adapt_columns(const TableColumns<PartRow>& columns, const Part& part) {
  TableColumns<Row> result;
  for (const TableColumn<PartRow>& column : columns) {
    result.push_back({column.name, column.unit, column.meaning,
                      [part, value = column.value](const Row& row) { return value(part(row)); }});
  }
  return result;
}

/// Makes columns with equal unit and meaning. Column `names[i]` has the value `values(row)[i]`.
template <class Row, class Values>
TableColumns<Row> array_columns(const std::vector<std::string>& names, const std::string& unit,
                                const std::string& meaning, const Values& values) {
  TableColumns<Row> columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    columns.push_back({names[i], unit, meaning,
                       [values, i](const Row& row) { return std::invoke(values, row)[i]; }});
  }
  return columns;
}

template <class Row>
TableColumns<Row> concatenated_columns(std::initializer_list<TableColumns<Row>> parts) {
  TableColumns<Row> all;
  for (const TableColumns<Row>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

template <class Row>
std::string csv_header(const TableColumns<Row>& columns) {
  std::string header;
  for (const TableColumn<Row>& column : columns) {
    header += (header.empty() ? "" : ",") + column.name;
  }
  return header;
}

template <class Row>
void append_csv_row(CsvWriter& csv, const TableColumns<Row>& columns, const Row& row) {
  for (const TableColumn<Row>& column : columns) {
    const TableCell cell = column.value(row);
    if (const auto* count = std::get_if<std::uint64_t>(&cell)) csv.write_count(*count);
    if (const auto* number = std::get_if<double>(&cell)) csv.write_cell(*number);
    if (const auto* text = std::get_if<std::string>(&cell)) csv.write_cell(*text);
  }
  csv.end_row();
}

template <class Row>
std::string format_csv(const TableColumns<Row>& columns, const std::vector<Row>& rows) {
  CsvWriter csv;
  csv.write_header(csv_header(columns));
  for (const Row& row : rows) append_csv_row(csv, columns, row);
  return csv.take_text();
}

}  // namespace clast
