#include "core/files/text_scanner.hpp"

#include <charconv>
#include <limits>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// The longest word worth repeating in a message.
constexpr std::size_t kQuoted = 40;

std::string quoted(std::string_view word) {
  if (word.empty()) return "the line ends";
  std::string text;
  for (const char c : word.substr(0, kQuoted)) text += c >= 32 && c < 127 ? c : '?';
  const bool decimal_comma = word.find(',') != std::string_view::npos;
  return "found \"" + text + "\"" +
         (decimal_comma ? "; this format requires decimal points, export it with decimal points"
                        : "");
}

}  // namespace

bool TextScanner::next_line() {
  if (text_.empty()) return false;
  const std::size_t end = text_.find_first_of("\r\n");
  line_ = text_.substr(0, end);
  if (end == std::string_view::npos) {
    text_ = {};
  } else {
    const bool two = text_[end] == '\r' && end + 1 < text_.size() && text_[end + 1] == '\n';
    text_.remove_prefix(end + (two ? 2 : 1));
  }
  ++line_number_;
  return true;
}

std::string_view TextScanner::next_word() {
  std::size_t begin = 0;
  while (begin < line_.size() && is_blank(line_[begin])) ++begin;
  std::size_t end = begin;
  while (end < line_.size() && !is_blank(line_[end])) ++end;
  const std::string_view found = line_.substr(begin, end - begin);
  line_.remove_prefix(end);
  return found;
}

double TextScanner::next_number() {
  const std::string_view text = next_word();
  if (const std::optional<double> value = parse_number_token(text)) return *value;
  throw InputError(line_prefix() + "a number is needed, " + quoted(text));
}

std::int64_t TextScanner::next_integer() {
  const std::string_view text = next_word();
  if (const std::optional<std::int64_t> value = parse_integer_token(text)) return *value;
  throw InputError(line_prefix() + "a whole number is needed, " + quoted(text));
}

std::optional<double> parse_number_token(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0.0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return parse_number(word);  // "-1.#IND"
  if (word.empty()) return std::nullopt;
  // Too small for a double is zero; too large is caught as not finite.
  if (code == std::errc::result_out_of_range) {
    const std::size_t exponent = word.find_first_of("eE");
    const bool tiny = exponent != std::string_view::npos && exponent + 1 < word.size() &&
                      word[exponent + 1] == '-';
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (code != std::errc()) return std::nullopt;
  return value;
}

std::optional<std::int64_t> parse_integer_token(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (code != std::errc() || end != word.data() + word.size() || word.empty()) return std::nullopt;
  return value;
}

}  // namespace clast
