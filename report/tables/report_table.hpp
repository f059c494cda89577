#pragma once
/// Tables of a report. Each is declared once for CSV, Python and docs/formats.md.
#include <functional>
#include <string>
#include <vector>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/files/table_values.hpp"

namespace clast {

template <class Source>
struct ReportTable {
  std::string name;  ///< file name without ".csv"
  std::function<std::string(const Source&)> csv;
  std::function<TableValues(const Source&)> values;
};

template <class Source>
std::vector<std::string> table_names(const std::vector<ReportTable<Source>>& tables) {
  std::vector<std::string> names;
  for (const ReportTable<Source>& table : tables) names.push_back(table.name);
  return names;
}

/// Finds a table of a report by its name.
/// @throws InputError  if there is no such table; the message lists all tables
template <class Source>
const ReportTable<Source>& find_report_table(const std::vector<ReportTable<Source>>& tables,
                                             const std::string& name) {
  for (const ReportTable<Source>& table : tables) {
    if (table.name == name) return table;
  }
  throw InputError("\"" + name + "\" is no table; there are " +
                   comma_separated(table_names(tables)));
}

/// True if a file has the name of one of the tables, such as "runs.csv".
template <class Source>
bool is_table_file(const std::vector<ReportTable<Source>>& tables, const std::string& file) {
  for (const ReportTable<Source>& table : tables) {
    if (file == table.name + ".csv") return true;
  }
  return false;
}

}  // namespace clast
