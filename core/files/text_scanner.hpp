#pragma once
/// Words and numbers of a text, line by line, without copying it.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace clast {

/// A cursor over text. Lines end with LF, CR LF or CR; a byte order mark before the first is passed
/// over.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text)
      : text_(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text) {}

  /// Moves to the next line; false at the end.
  bool next_line();
  /// Number of the current line, from 1.
  std::size_t line_number() const { return line_number_; }
  /// What is left of the current line.
  std::string_view rest_of_line() const { return line_; }
  /// The next word of the line; empty when there is none.
  std::string_view next_word();
  /// Text after the current line.
  std::string_view remaining_text() const { return text_; }

  /// The next word of the line as a number.
  /// @throws InputError  naming line and word
  double next_number();
  std::int64_t next_integer();
  /// "line 12: " to put before a message.
  std::string line_prefix() const { return "line " + std::to_string(line_number_) + ": "; }

 private:
  std::string_view text_, line_;
  std::size_t line_number_ = 0;
};

/// The whole word as a number ("nan" and "inf" are numbers here), or none.
std::optional<double> parse_number_token(std::string_view word);
std::optional<std::int64_t> parse_integer_token(std::string_view word);

}  // namespace clast
