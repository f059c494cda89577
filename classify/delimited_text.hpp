#pragma once
/// Text tables as records of fields, whatever program wrote them.
#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace clast {

/// One row. Fields are trimmed and without their quotes; they are valid until the next row is read.
struct Record {
  std::size_t line = 0;  ///< where it begins, from 1
  std::vector<std::string_view> fields;
};

/// @param name  of the file, for messages
/// @throws InputError  not text in an encoding that has ASCII in it, such as a workbook or UTF-16
void check_is_text(std::string_view text, const std::string& name);

/// Walks over the rows of a text. Blank rows and rows that begin with # are passed over.
class DelimitedText {
 public:
  /// Finds the separator on the first row: a line "sep=;" as Excel writes it, else a semicolon, tab
  /// or comma that is there, else blanks.
  /// @param text  that passed `check_is_text`; outlives this
  /// @param name  of the file, for messages
  DelimitedText(std::string_view text, std::string name);

  /// False at the end.
  /// @throws InputError  a quote that is never closed
  bool next(Record& record);
  char separator() const { return separator_; }

 private:
  std::string_view quoted_field(std::size_t opened);
  std::string_view plain_field();
  void end_line();
  bool at_line_end() const {
    return place_ >= text_.size() || text_[place_] == '\n' || text_[place_] == '\r';
  }

  std::string_view text_;
  std::string name_;
  std::size_t place_ = 0;
  std::size_t line_ = 1;
  char separator_ = ',';
  std::deque<std::string> unquoted_;  ///< fields of the present row whose text had to be changed
};

}  // namespace clast
