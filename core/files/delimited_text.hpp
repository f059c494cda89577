#pragma once
/// Reading of delimited text tables.
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clast {

/// One row of a table. Fields are trimmed, without quotes, and valid until the next row is read.
struct Record {
  std::size_t line = 0;  ///< first line of the row, from 1
  std::vector<std::string_view> fields;
};

/// Text of a table as UTF-8.
struct DecodedText {
  std::string text;
  bool from_latin1 = false;  ///< true if it was decoded from Windows-1252
};

/// Decodes the content of a table.
/// @param content  of a file
/// @param file  its name, for messages
/// @throws InputError  if it is not text in an ASCII-based encoding, such as a workbook or UTF-16
DecodedText decode_text(std::string content, const std::string& file);

/// Detects the separator of a table from one row: a semicolon, tab or comma outside quotes, in this
/// order; otherwise ' ' for blanks, also if all commas are inside numbers of a blank-separated row.
char detect_separator(std::string_view line);

/// Parses a number field; a decimal comma is accepted unless commas separate columns.
std::optional<double> parse_number_field(std::string_view field,
                                         char separator);  ///< empty: detected from the first row

/// True if a quoted field of a comma-separated table contains a number with a comma: "1,234" could
/// be 1.234 or 1234.
bool is_ambiguous_number(std::string_view field, char separator);

/// End of messages about decimal commas in comma-separated tables.
inline constexpr const char* kDecimalCommaHint =
    "where commas are decimal signs, separate the columns by semicolons or tabs, or write decimal "
    "points";

/// Deviations of a table from the defaults.
struct TableDialect {
  std::optional<char> separator = {};  ///< none: as the first row has it
  bool inline_comments = false;        ///< # starts a comment anywhere, not only at the row start
  bool any_heading_width = false;      ///< the first row may have any number of fields
};

/// Reads the rows of a text; empty rows and rows that start with # are skipped.
class DelimitedTextReader {
 public:
  /// Detects the separator from the first row: a line "sep=;" as written by Excel, otherwise
  /// `detect_separator`.
  /// @param text  from `decode_text`; must outlive this object
  /// @param file  its name, for messages
  DelimitedTextReader(std::string_view text, std::string file, const TableDialect& rules = {});

  /// Reads the next row; false at the end.
  /// @throws InputError  if a quote is not closed, or the number of fields differs from the first
  ///                     row; names file, line and both numbers
  bool read_record(Record& record);
  char separator() const { return separator_; }

 private:
  void read_fields(Record& record);
  std::string_view read_quoted_field(std::size_t opened);
  std::string_view read_unquoted_field();
  void skip_blanks();
  void skip_line_end();
  void check_field_count(const Record& record);
  bool at_row_end() const {
    return position_ >= text_.size() || text_[position_] == '\n' || text_[position_] == '\r' ||
           (rules_.inline_comments && text_[position_] == '#');
  }

  std::string_view text_;
  std::string file_;
  TableDialect rules_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  std::size_t rows_ = 0;
  char separator_ = ',';
  std::size_t fields_ = 0;            ///< of each row; 0 before the first row
  std::size_t counted_line_ = 0;      ///< line of the row that determined `fields_`
  std::deque<std::string> unquoted_;  ///< modified fields of the current row
};

}  // namespace clast
