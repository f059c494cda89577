#pragma once
/// Comma-separated text: lists in, tables out.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace clast {

/// "a, b,c" as {"a", "b", "c"}; empty items are dropped.
std::vector<std::string> split_list(const std::string& text);

/// A text as it is written into a cell: where a spreadsheet would run it as a formula, since it
/// begins with one of = + - @, a tab or a line end and is no number, an apostrophe stands before
/// it, which a spreadsheet shows as text. Texts that look so already get one more, so that
/// `unescape_formula` gives back each of them.
std::string escape_formula(std::string_view text);
/// The text of a cell that `escape_formula` may have written: without that apostrophe.
std::string_view unescape_formula(std::string_view cell);

/// CSV after RFC 4180, with "\n" line ends. Numbers are the shortest text that reads back to the
/// same bits (-0 is written as 0); what is not known is an empty cell. Texts that a spreadsheet
/// would run are written by `escape_formula`, in quotes.
/// @cite rfc4180
class CsvWriter {
 public:
  void write_cell(std::string_view text);
  void write_cell(const char* text) { write_cell(std::string_view(text)); }
  void write_cell(double value);  ///< empty when it is not finite
  void write_count(std::uint64_t value);
  void write_empty_cells(int count);
  void end_row();
  /// @param names  with commas between them
  void write_header(std::string_view names);

  /// What was written since the last call.
  std::string take_text();

 private:
  void write_separator();

  std::string text_;
  bool first_ = true;
};

}  // namespace clast
