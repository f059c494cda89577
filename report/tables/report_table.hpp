#pragma once
/// Tables of a report by name: each is declared once, for its CSV file, for columns of values, and
/// for its part of docs/formats.md.
#include <functional>
#include <string>
#include <vector>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/files/table_values.hpp"

namespace clast {

/// What a table holds of a source.
template <class Source>
struct ReportTable {
  std::string name;  ///< of its file, without ".csv"
  std::function<std::string(const Source&)> csv;
  std::function<TableValues(const Source&)> values;
};

template <class Source>
std::vector<std::string> table_names(const std::vector<ReportTable<Source>>& tables) {
  std::vector<std::string> names;
  for (const ReportTable<Source>& table : tables) names.push_back(table.name);
  return names;
}

/// @throws InputError  no such table; the message lists them
template <class Source>
const ReportTable<Source>& find_table(const std::vector<ReportTable<Source>>& tables,
                                      const std::string& name) {
  for (const ReportTable<Source>& table : tables) {
    if (table.name == name) return table;
  }
  throw InputError("\"" + name + "\" is no table; there are " +
                   comma_separated(table_names(tables)));
}

/// True if the file is that of a table, "NAME.csv".
template <class Source>
bool is_table_file(const std::vector<ReportTable<Source>>& tables, const std::string& file) {
  for (const ReportTable<Source>& table : tables) {
    if (file == table.name + ".csv") return true;
  }
  return false;
}

}  // namespace clast
