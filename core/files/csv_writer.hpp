#pragma once
/// Comma-separated text.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace clast {

/// Splits a comma-separated list: "a, b,c" gives {"a", "b", "c"}. Empty items are left out.
std::vector<std::string> split_comma_separated(const std::string& text);

/// Escapes a cell text that a spreadsheet would execute as a formula, by an apostrophe before it.
/// Such a text starts with =, +, -, @, a tab or a line end, and is not a number. A text that looks
/// escaped gets another apostrophe, so that `unescape_spreadsheet_formula` restores every text.
std::string escape_spreadsheet_formula(std::string_view text);
/// Removes the apostrophe added by `escape_spreadsheet_formula`.
std::string_view unescape_spreadsheet_formula(std::string_view cell);

/// Writer of CSV (RFC 4180) with CRLF line ends. Numbers have the fewest digits that restore the
/// same double; -0 is written as 0. Unknown values are empty cells. Texts that a spreadsheet would
/// execute are escaped by `escape_spreadsheet_formula` and quoted.
/// @cite rfc4180
class CsvWriter {
 public:
  void write_cell(std::string_view text);
  void write_cell(const char* text) { write_cell(std::string_view(text)); }
  void write_cell(double value);  ///< writes an empty cell if the value is not finite
  void write_count(std::uint64_t value);
  void write_empty_cells(int count);
  void end_row();
  /// Writes the header row.
  /// @param names  column names, separated by commas
  void write_header(std::string_view names);

  /// Returns and removes the text written since the last call.
  std::string take_text();

 private:
  void write_separator();

  std::string text_;
  bool first_ = true;
};

}  // namespace clast
