#include "core/files/csv_writer.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <utility>

#include "core/number_text.hpp"

namespace clast {
namespace {

/// True if a spreadsheet reads the text, after leading apostrophes, as a formula.
bool begins_a_formula(std::string_view text) {
  const std::size_t first = text.find_first_not_of('\'');
  return first != std::string_view::npos &&
         std::string_view("=+-@\t\r\n").find(text[first]) != std::string_view::npos;
}

}  // namespace

std::vector<std::string> split_comma_separated(const std::string& text) {
  std::vector<std::string> items;
  std::istringstream stream(text);
  for (std::string item; std::getline(stream, item, ',');) {
    const std::size_t begin = item.find_first_not_of(" \t");
    if (begin == std::string::npos) continue;
    items.push_back(item.substr(begin, item.find_last_not_of(" \t") - begin + 1));
  }
  return items;
}

std::string escape_spreadsheet_formula(std::string_view text) {
  const bool guarded = begins_a_formula(text) && !parse_number(text);
  return (guarded ? "'" : "") + std::string(text);
}

std::string_view unescape_spreadsheet_formula(std::string_view cell) {
  if (cell.starts_with('\'') && begins_a_formula(cell)) cell.remove_prefix(1);
  return cell;
}

void CsvWriter::write_separator() {
  if (!first_) text_ += ',';
  first_ = false;
}

void CsvWriter::write_cell(std::string_view text) {
  write_separator();
  const std::string written = escape_spreadsheet_formula(text);
  if (written.size() == text.size() && text.find_first_of(",\"\r\n") == std::string_view::npos) {
    text_ += text;
    return;
  }
  text_ += '"';
  for (const char c : written) text_.append(c == '"' ? 2 : 1, c);
  text_ += '"';
}

void CsvWriter::write_cell(double value) {
  write_separator();
  if (!std::isfinite(value)) return;
  std::array<char, 32> text;
  // A minus before zero is a residue of signs, and reads as if it meant something.
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value == 0.0 ? 0.0 : value);
  text_.append(text.data(), end.ptr);
}

void CsvWriter::write_count(std::uint64_t value) {
  write_cell(std::string_view(std::to_string(value)));
}

void CsvWriter::write_empty_cells(int count) {
  for (int i = 0; i < count; ++i) write_cell(std::string_view());
}

void CsvWriter::end_row() {
  text_ += '\n';
  first_ = true;
}

void CsvWriter::write_header(std::string_view names) {
  text_ += names;
  end_row();
}

std::string CsvWriter::take_text() { return std::exchange(text_, {}); }

}  // namespace clast
