#pragma once
/// Comma-separated text.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace clast {

/// Splits "a, b,c" into {"a", "b", "c"}; empty items are dropped.
std::vector<std::string> split_list(const std::string& text);

/// Escapes a cell text that a spreadsheet would execute as a formula, because it starts with = + -
/// @, a tab or a line end and is not a number: an apostrophe is put before it. Texts that look
/// escaped get another one, so that `unescape_formula` restores every text.
std::string escape_formula(std::string_view text);
/// Removes the apostrophe of `escape_formula`.
std::string_view unescape_formula(std::string_view cell);

/// Writer of CSV (RFC 4180) with CRLF line ends. Numbers have the fewest digits that restore their
/// bits (-0 is written as 0); unknown values are empty cells. Texts that a spreadsheet would
/// execute are escaped by `escape_formula` and quoted.
/// @cite rfc4180
class CsvWriter {
 public:
  void write_cell(std::string_view text);
  void write_cell(const char* text) { write_cell(std::string_view(text)); }
  void write_cell(double value);  ///< empty when it is not finite
  void write_count(std::uint64_t value);
  void write_empty_cells(int count);
  void end_row();
  /// Writes the header.
  /// @param names  separated by commas
  void write_header(std::string_view names);

  /// Returns the text written since the last call.
  std::string take_text();

 private:
  void write_separator();

  std::string text_;
  bool first_ = true;
};

}  // namespace clast
