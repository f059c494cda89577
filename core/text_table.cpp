#include "core/text_table.hpp"

#include <algorithm>

#include "core/printable.hpp"

namespace clast {

namespace {

/// Columns taken on a terminal: UTF-8 continuation bytes take none.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789+-.e%") == std::string::npos;
}

}  // namespace

std::string TextTable::text() const {
  std::vector<std::vector<std::string>> shown = rows;
  for (std::vector<std::string>& row : shown) {
    for (std::string& cell : row) cell = escape_nonprintable(cell);
  }
  std::vector<std::size_t> widths;
  std::vector<bool> right;
  for (std::size_t column = 0; column < headings.size(); ++column) {
    widths.push_back(width(headings[column]));
    bool numbers = column > 0;
    for (const auto& row : shown) {
      widths[column] = std::max(widths[column], width(row[column]));
      numbers = numbers && (row[column].empty() || is_number(row[column]));
    }
    right.push_back(numbers);
  }
  std::string result;
  const auto add_line = [&](const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t column = 0; column < cells.size(); ++column) {
      const std::string padding(widths[column] - width(cells[column]), ' ');
      if (column) line += "  ";
      line += right[column] ? padding + cells[column] : cells[column] + padding;
    }
    result += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  add_line(headings);
  for (const auto& row : shown) add_line(row);
  return result;
}

}  // namespace clast
