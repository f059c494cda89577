#include "classify/delimited_text.hpp"

#include "core/error.hpp"

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

/// Semicolons or tabs leave the comma free to be a decimal sign.
char separator_of(std::string_view line) {
  std::string bare;  // what is not in quotes
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (!quoted) bare += c;
  }
  for (const char c : {';', '\t'}) {
    if (bare.find(c) != std::string::npos) return c;
  }
  return bare.find(',') == std::string::npos || has_decimal_commas(trimmed(bare)) ? ' ' : ',';
}

}  // namespace

void check_is_text(std::string_view text, const std::string& name) {
  if (text.starts_with("PK\x03\x04") || text.starts_with("\xd0\xcf\x11\xe0")) {
    throw InputError(name + ": is a workbook, not a text table; save the sheet as CSV (UTF-8)");
  }
  const bool utf16 = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
  if (utf16 || text.substr(0, 4096).find('\0') != std::string_view::npos) {
    throw InputError(name + ": is " + (utf16 ? "text in UTF-16" : "no text") +
                     "; save the table as CSV (UTF-8)");
  }
}

DelimitedText::DelimitedText(std::string_view text, std::string name)
    : text_(text), name_(std::move(name)) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  for (std::size_t at = 0; at < text_.size();) {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at), text_.size());
    const std::string_view line = trimmed(text_.substr(at, end - at));
    if (line.size() == 5 && line.starts_with("sep=")) {
      separator_ = line.back();
      place_ = end;
      end_line();
      return;
    }
    if (!line.empty() && line.front() != '#') {
      // The whole of the text: a quoted heading may go on over the line's end.
      separator_ = separator_of(text_.substr(at, end - at));
      return;
    }
    at = end + 1;
  }
}

void DelimitedText::end_line() {
  if (place_ >= text_.size()) return;
  const bool two = text_[place_] == '\r' && place_ + 1 < text_.size() && text_[place_ + 1] == '\n';
  place_ += two ? 2 : 1;
  ++line_;
}

std::string_view DelimitedText::quoted_field(std::size_t opened) {
  std::string content;
  ++place_;
  while (true) {
    if (place_ >= text_.size()) {
      throw InputError(name_ + ": the quote opened in row " + std::to_string(opened) +
                       " is never closed; close it or remove it");
    }
    const char c = text_[place_];
    if (c == '"' && place_ + 1 < text_.size() && text_[place_ + 1] == '"') {
      content += '"';
      place_ += 2;
    } else if (c == '"') {
      ++place_;
      break;
    } else if (c == '\n' || c == '\r') {
      content += ' ';
      end_line();
    } else {
      content += c;
      ++place_;
    }
  }
  content += plain_field();  // what stands between the closing quote and the separator
  unquoted_.push_back(std::move(content));
  return trimmed(unquoted_.back());
}

std::string_view DelimitedText::plain_field() {
  const std::size_t begin = place_;
  if (separator_ == ' ') {
    while (!at_line_end() && text_[place_] != ' ' && text_[place_] != '\t') ++place_;
  } else {
    while (!at_line_end() && text_[place_] != separator_) ++place_;
  }
  return trimmed(text_.substr(begin, place_ - begin));
}

bool DelimitedText::next(Record& record) {
  record.fields.clear();
  unquoted_.clear();
  while (place_ < text_.size()) {
    record.line = line_;
    const auto skip_blanks = [&] {
      while (!at_line_end() && (text_[place_] == ' ' || text_[place_] == '\t') &&
             text_[place_] != separator_) {
        ++place_;
      }
      if (separator_ == ' ') {
        while (!at_line_end() && (text_[place_] == ' ' || text_[place_] == '\t')) ++place_;
      }
    };
    skip_blanks();
    if (!at_line_end() && text_[place_] == '#') {
      while (!at_line_end()) ++place_;
    }
    bool something = false;
    while (!at_line_end()) {
      const bool quoted = text_[place_] == '"';
      record.fields.push_back(quoted ? quoted_field(record.line) : plain_field());
      something = something || quoted || !record.fields.back().empty();
      if (at_line_end()) break;
      if (separator_ != ' ') {
        ++place_;
        skip_blanks();
        if (at_line_end()) record.fields.emplace_back();  // the row ends with its separator
      } else {
        skip_blanks();
      }
    }
    end_line();
    if (something) return true;
    record.fields.clear();
  }
  return false;
}

}  // namespace clast
