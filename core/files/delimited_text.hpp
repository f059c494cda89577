#pragma once
/// Reading of delimited text tables.
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clast {

/// One row of a table. Fields are trimmed and without quotes, and valid until the next row is read.
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
/// @param content  content of a file
/// @param file  name of the file, for messages
/// @throws InputError  if it is not text in an ASCII-based encoding, such as a workbook or UTF-16
DecodedText decode_table_text(std::string content, const std::string& file);

/// Detects the separator of a table from one row. It is the first of semicolon, tab and comma that
/// occurs outside quotes, otherwise ' ' for blanks. Commas do not count if all of them are decimal
/// commas in a row separated by blanks.
char detect_separator(std::string_view line);

/// Parses a number field. A decimal comma is accepted unless commas separate columns.
std::optional<double> parse_number_field(std::string_view field,
                                         char separator);  ///< empty: detected from the first row

/// True if a quoted field of a comma-separated table is a number such as "1,234" (1.234 or 1234).
bool is_ambiguous_number(std::string_view field, char separator);

/// Advice that ends error messages about decimal commas in comma-separated tables.
inline constexpr const char* kDecimalCommaHint =
    "where commas are decimal signs, separate the columns by semicolons or tabs, or write decimal "
    "points";

/// Format options of a delimited text table.
struct TableDialect {
  std::optional<char> separator = {};  ///< empty: detected from the first row
  bool inline_comments = false;        ///< true if # starts a comment anywhere in a row
  bool any_heading_width = false;      ///< true if the first row may have another number of fields
};

/// Reads the rows of a text. Empty rows and rows that start with # are skipped.
class DelimitedTextReader {
 public:
  /// Constructs a reader. Detects the separator by `detect_separator`, or from a first line "sep=;"
  /// as written by Excel.
  /// @param text  text from `decode_table_text`; must outlive this object
  /// @param file  name of the file, for messages
  DelimitedTextReader(std::string_view text, std::string file, const TableDialect& rules = {});

  /// Reads the next row; returns false at the end.
  /// @throws InputError  if a quote is not closed, or if the number of fields differs from the
  ///                     first row; the message names file, line and both numbers
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
  std::size_t fields_ = 0;            ///< number of fields of each row; 0 before the first row
  std::size_t counted_line_ = 0;      ///< line of the row that determined `fields_`
  std::deque<std::string> unquoted_;  ///< modified fields of the current row
};

}  // namespace clast
