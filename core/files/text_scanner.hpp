#pragma once
/// Scanning of words and numbers of a text, line by line, without copies.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace clast {

/// Cursor over a text. Lines end with LF, CR LF or CR; a byte order mark is skipped.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text)
      : text_(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text) {}

  /// Moves to the next line. Returns false at the end of the text.
  bool next_line();
  /// Returns the number of the current line, from 1.
  std::size_t line_number() const { return line_number_; }
  std::string_view rest_of_line() const { return line_; }
  /// Returns the next word of the line; empty at its end.
  std::string_view next_word();
  /// Returns the text after the current line.
  std::string_view remaining_text() const { return text_; }

  /// Parses the next word as a number.
  /// @throws InputError if it is not a number; names line and word
  double next_number();
  std::int64_t next_integer();
  /// Returns "line 12: " as prefix of messages.
  std::string line_prefix() const { return "line " + std::to_string(line_number_) + ": "; }

 private:
  std::string_view text_, line_;
  std::size_t line_number_ = 0;
};

/// Parses a whole word as a number ("nan" and "inf" are accepted); empty if it is not one.
std::optional<double> parse_number_token(std::string_view word);
std::optional<std::int64_t> parse_integer_token(std::string_view word);

}  // namespace clast
