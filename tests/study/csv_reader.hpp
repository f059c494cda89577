#pragma once
/// Reads RFC 4180 text back, independently of the writer under test.
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace clast {

struct CsvTable {
  using Row = std::map<std::string, std::string>;
  std::vector<std::string> columns;
  std::vector<Row> rows;

  double number(std::size_t row, const std::string& column) const {
    const std::string& text = rows.at(row).at(column);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') throw std::runtime_error(column + ": not a number: " + text);
    return value;
  }
  /// The first row where `column` reads `value`.
  std::size_t find(const std::string& column, const std::string& value) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].at(column) == value) return i;
    }
    throw std::runtime_error("no row with " + column + " " + value);
  }
};

inline CsvTable read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    std::string& cell = lines.back().back();
    if (quoted) {
      if (c != '"') {
        cell += c;
      } else if (i + 1 < text.size() && text[i + 1] == '"') {
        cell += '"';
        ++i;
      } else {
        quoted = false;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',') {
      lines.back().emplace_back();
    } else if (c == '\n') {
      lines.emplace_back(1);
    } else {
      cell += c;
    }
  }
  lines.pop_back();  // what follows the last line end
  CsvTable table;
  table.columns = lines.at(0);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].size() != table.columns.size()) throw std::runtime_error("ragged row");
    std::map<std::string, std::string> row;
    for (std::size_t k = 0; k < lines[i].size(); ++k) row[table.columns[k]] = lines[i][k];
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace clast
