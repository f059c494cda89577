#pragma once
/// Text tables as records of fields, whichever program wrote them. Every table that clast reads is
/// read with this.
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clast {

/// One row. Fields are trimmed and without their quotes; they are valid until the next row is read.
struct Record {
  std::size_t line = 0;  ///< where it begins, from 1
  std::vector<std::string_view> fields;
};

/// A table's text as UTF-8.
struct DecodedText {
  std::string text;
  bool from_latin1 = false;  ///< it was taken for Windows-1252
};

/// @param content  of a file
/// @param file     its name, for messages
/// @throws InputError  not text in an encoding that has ASCII in it, such as a workbook or UTF-16
DecodedText decode_text(std::string content, const std::string& file);

/// The separator of a table with this row: a semicolon, tab or comma that is there outside of
/// quotes, in this order, else ' ' for blanks; that too where all commas stand inside numbers of a
/// row separated by blanks.
char detect_separator(std::string_view line);

/// The number in a field of a table with this separator; a decimal comma is read where commas do
/// not separate columns.
std::optional<double> parse_number_field(std::string_view field, char separator);

/// Whether a field of a table whose columns are separated by commas holds a number with a decimal
/// comma, in quotes: "1,234" could be 1.234 or 1234.
bool is_ambiguous_number(std::string_view field, char separator);

/// What to do where commas separate columns and decimals: the end of a message.
inline constexpr const char* kDecimalCommaHint =
    "where commas are decimal signs, separate the columns by semicolons or tabs, or write decimal "
    "points";

/// How a table differs from the usual.
struct TableDialect {
  std::optional<char> separator = {};  ///< none: as the first row has it
  bool inline_comments = false;    ///< a # ends its row wherever it stands, not only at its start
  bool any_heading_width = false;  ///< the first row may have any number of fields
};

/// Iterates over the rows of a text. Empty rows and rows that begin with # are skipped.
class DelimitedTextReader {
 public:
  /// Finds the separator on the first row: a line "sep=;" as Excel writes it, else
  /// `detect_separator`.
  /// @param text  from `decode_text`; outlives this
  /// @param file  its name, for messages
  DelimitedTextReader(std::string_view text, std::string file, const TableDialect& rules = {});

  /// False at the end.
  /// @throws InputError  a quote that is never closed, or a row with more or fewer fields than the
  ///                     first; file, line and both numbers
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
  std::size_t fields_ = 0;            ///< of each row; 0 until the first that counts
  std::size_t counted_line_ = 0;      ///< of the row that set `fields_`
  std::deque<std::string> unquoted_;  ///< fields of the current row whose text had to be changed
};

}  // namespace clast
