#include "core/files/delimited_text.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"

namespace clast {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Every blank-separated word holds one comma at most, between digits: "1,5 1,2 0,8".
bool has_decimal_commas(std::string_view line) {
  bool comma_in_word = false, several_words = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ' ' || line[i] == '\t') {
      several_words = true;
      comma_in_word = false;
    } else if (line[i] == ',') {
      const bool inside =
          i > 0 && i + 1 < line.size() && is_digit(line[i - 1]) && is_digit(line[i + 1]);
      if (!inside || comma_in_word) return false;
      comma_in_word = true;
    }
  }
  return several_words;
}

/// Up to the first line end outside of quotes.
std::string_view first_row(std::string_view text) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (!quoted && (text[i] == '\n' || text[i] == '\r')) return text.substr(0, i);
  }
  return text.substr(0, text.find_first_of("\r\n"));  // a quote that is never closed
}

void check_is_text(std::string_view text, const std::string& file) {
  if (text.starts_with("PK\x03\x04") || text.starts_with("\xd0\xcf\x11\xe0")) {
    throw InputError(file + ": is a workbook, not a text table; save the sheet as CSV (UTF-8)");
  }
  const bool utf16 = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
  if (utf16 || text.substr(0, 4096).find('\0') != std::string_view::npos) {
    throw InputError(file + ": is " + (utf16 ? "text in UTF-16" : "no text") +
                     "; save the table as CSV (UTF-8)");
  }
}

}  // namespace

DecodedText decode_table_text(std::string content, const std::string& file) {
  check_is_text(content, file);  // before bytes that are not text are read as letters
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (is_utf8(content)) {
    if (content.starts_with(kByteOrderMark)) content.erase(0, kByteOrderMark.size());
    return {std::move(content), false};
  }
  return {utf8_from_latin1(content), true};
}

char detect_separator(std::string_view line) {
  std::string bare;  // what is not in quotes
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (!quoted) bare += c;
  }
  for (const char c : {';', '\t'}) {  // with these the comma may be a decimal sign
    if (bare.find(c) != std::string::npos) return c;
  }
  return bare.find(',') == std::string::npos || has_decimal_commas(trimmed(bare)) ? ' ' : ',';
}

std::optional<double> parse_number_field(std::string_view field, char separator) {
  constexpr std::size_t kMaxDigits = 64;  // longer than any number in use
  if (field.find(',') == std::string_view::npos) return parse_number(field);
  if (separator == ',' || field.size() > kMaxDigits) return std::nullopt;
  std::string text(field);
  std::replace(text.begin(), text.end(), ',', '.');
  return parse_number(text);
}

bool is_ambiguous_number(std::string_view field, char separator) {
  return separator == ',' && field.find(',') != std::string_view::npos &&
         parse_number_field(field, ';').has_value();
}

DelimitedTextReader::DelimitedTextReader(std::string_view text, std::string file,
                                         const TableDialect& rules)
    : text_(text), file_(std::move(file)), rules_(rules) {
  for (std::size_t at = 0; at < text_.size();) {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at), text_.size());
    const std::string_view line = trimmed(text_.substr(at, end - at));
    if (line.size() == 5 && line.starts_with("sep=")) {
      separator_ = line.back();
      position_ = end;
      line_ += static_cast<std::size_t>(
          std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
      skip_line_end();
      break;
    }
    if (!line.empty() && line.front() != '#') {
      separator_ = detect_separator(first_row(text_.substr(at)));
      break;
    }
    at = end + 1;
  }
  separator_ = rules_.separator.value_or(separator_);
}

void DelimitedTextReader::skip_line_end() {
  if (position_ >= text_.size()) return;
  const bool two =
      text_[position_] == '\r' && position_ + 1 < text_.size() && text_[position_ + 1] == '\n';
  position_ += two ? 2 : 1;
  ++line_;
}

std::string_view DelimitedTextReader::read_quoted_field(std::size_t opened) {
  std::string content;
  ++position_;
  while (true) {
    if (position_ >= text_.size()) {
      throw InputError(file_ + ": the quote opened in row " + std::to_string(opened) +
                       " is never closed; close it or remove it");
    }
    const char c = text_[position_];
    if (c == '"' && position_ + 1 < text_.size() && text_[position_ + 1] == '"') {
      content += '"';
      position_ += 2;
    } else if (c == '"') {
      ++position_;
      break;
    } else if (c == '\n' || c == '\r') {
      content += ' ';
      skip_line_end();
    } else {
      content += c;
      ++position_;
    }
  }
  content += read_unquoted_field();  // what stands between the closing quote and the separator
  unquoted_.push_back(std::move(content));
  return unescape_spreadsheet_formula(trimmed(unquoted_.back()));
}

std::string_view DelimitedTextReader::read_unquoted_field() {
  const std::size_t begin = position_;
  if (separator_ == ' ') {
    while (!at_row_end() && text_[position_] != ' ' && text_[position_] != '\t') ++position_;
  } else {
    while (!at_row_end() && text_[position_] != separator_) ++position_;
  }
  return unescape_spreadsheet_formula(trimmed(text_.substr(begin, position_ - begin)));
}

void DelimitedTextReader::skip_blanks() {
  const bool blanks_separate = separator_ == ' ';
  while (!at_row_end() && (text_[position_] == ' ' || text_[position_] == '\t') &&
         (blanks_separate || text_[position_] != separator_)) {
    ++position_;
  }
}

void DelimitedTextReader::read_fields(Record& record) {
  skip_blanks();
  while (!at_row_end()) {
    const bool quoted = text_[position_] == '"';
    record.fields.push_back(quoted ? read_quoted_field(record.line) : read_unquoted_field());
    if (at_row_end()) return;
    if (separator_ != ' ') ++position_;
    skip_blanks();
    if (separator_ != ' ' && at_row_end())
      record.fields.emplace_back();  // it ends with its separator
  }
}

bool DelimitedTextReader::read_record(Record& record) {
  while (position_ < text_.size()) {
    record.fields.clear();
    unquoted_.clear();
    record.line = line_;
    const std::size_t begin = position_;
    skip_blanks();
    if (position_ >= text_.size() || text_[position_] != '#') read_fields(record);
    const bool quoted = text_.substr(begin, position_ - begin).find('"') != std::string_view::npos;
    position_ =
        std::min(text_.find_first_of("\r\n", position_), text_.size());  // a remark is skipped
    skip_line_end();
    if (quoted || std::any_of(record.fields.begin(), record.fields.end(),
                              [](std::string_view field) { return !field.empty(); })) {
      check_field_count(record);
      return true;
    }
  }
  record.fields.clear();
  return false;
}

void DelimitedTextReader::check_field_count(const Record& record) {
  const bool heading = rules_.any_heading_width && rows_ == 0;
  ++rows_;
  if (heading) return;
  if (fields_ == 0) {
    fields_ = record.fields.size();
    counted_line_ = record.line;
    return;
  }
  if (record.fields.size() == fields_) return;
  const std::string advice =
      separator_ == ',' ? kDecimalCommaHint
      : separator_ == ' '
          ? "columns are separated by blanks here: put texts with blanks in quotes, "
            "or separate the columns by semicolons"
          : "put texts that hold the separator in quotes, and leave missing values "
            "empty between their separators";
  throw InputError(
      file_ + ":" + std::to_string(record.line) + ": has " + std::to_string(record.fields.size()) +
      (record.fields.size() == 1 ? " field" : " fields") + ", but line " +
      std::to_string(counted_line_) + " has " + std::to_string(fields_) + "; " + advice);
}

}  // namespace clast
