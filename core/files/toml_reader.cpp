#include "core/files/toml_reader.hpp"
#include "core/comma_separated.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "core/files/toml_depth.hpp"
#include "core/printable.hpp"

namespace clast {
namespace {

// Longer values are cut in messages.
constexpr std::size_t kMaxValue = 80;

// The text of the file, to quote values as their author wrote them.
class SourceText {
 public:
  explicit SourceText(std::string_view text) {
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      lines_.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
  }

  /// Formats a value on one line, shortened if it is long.
  std::string quoted(const toml::source_region& region) const {
    std::string quote;
    for (std::size_t line = region.begin.line; line <= region.end.line; ++line) {
      if (line == 0 || line > lines_.size()) break;
      const std::string_view whole = lines_[line - 1];
      const std::size_t begin =
          line == region.begin.line ? byte_of_column(whole, region.begin.column) : 0;
      const std::size_t end =
          line == region.end.line ? byte_of_column(whole, region.end.column) : whole.size();
      for (const char letter : whole.substr(begin, end - begin)) {
        const bool blank = letter == ' ' || letter == '\t' || letter == '\r';
        if (!blank) quote += letter;
        if (blank && !quote.empty() && quote.back() != ' ') quote += ' ';
      }
      if (quote.size() > kMaxValue) return quote.substr(0, kMaxValue - 3) + "...";
    }
    while (quote.ends_with(' ')) quote.pop_back();
    return quote;
  }

 private:
  // toml++ counts columns in characters, from 1.
  static std::size_t byte_of_column(std::string_view line, std::size_t column) {
    std::size_t characters = 0;
    for (std::size_t byte = 0; byte < line.size(); ++byte) {
      const bool begins = (static_cast<unsigned char>(line[byte]) & 0xC0) != 0x80;
      if (begins && ++characters == column) return byte;
    }
    return line.size();
  }

  std::vector<std::string_view> lines_;
};

TomlNode converted(const toml::node& node, const SourceText& source) {
  using Kind = TomlNode::Kind;
  TomlNode result;
  result.line = node.source().begin.line;
  result.source_text = source.quoted(node.source());
  if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table) {
      result.table.push_back({std::string(key.str()), converted(value, source)});
    }
  } else if (const auto* array = node.as_array()) {
    result.kind = Kind::kList;
    for (const toml::node& element : *array) result.list.push_back(converted(element, source));
  } else if (const auto integer = node.value_exact<std::int64_t>()) {
    result.kind = Kind::kInteger;
    result.integer = *integer;
    result.number = static_cast<double>(*integer);
  } else if (const auto number = node.value_exact<double>()) {
    result.kind = Kind::kFloat;
    result.number = *number;
  } else if (const auto boolean = node.value_exact<bool>()) {
    result.kind = Kind::kBoolean;
    result.boolean = *boolean;
  } else if (const auto text = node.value_exact<std::string>()) {
    result.kind = Kind::kString;
    result.text = *text;
  } else {
    result.kind = Kind::kDate;
  }
  return result;
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

// A key that forgets its unit ("friction_angle" apart) is as near as one that is misspelt.
std::string suggestion(const std::string& key, const std::vector<std::string>& known) {
  const std::string* best = nullptr;
  std::size_t smallest = 0;
  for (const std::string& candidate : known) {
    std::size_t distance = edit_distance(key, candidate);
    if (candidate.starts_with(key) || key.starts_with(candidate))
      distance = std::min<std::size_t>(distance, 1);
    if (!best || distance < smallest) {
      best = &candidate;
      smallest = distance;
    }
  }
  if (best && smallest <= std::max<std::size_t>(2, key.size() / 3)) {
    return "did you mean " + *best + "?";
  }
  return "known here are " + comma_separated(known);
}
// Names appear in tables, file names and terminals, where a line end or a NUL breaks the text.
constexpr const char* kNoControls = "must be one line without control characters";
bool has_control_characters(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) == 0x7f;
  });
}

}  // namespace

const TomlNode* TomlNode::find(const std::string& key) const {
  for (const auto& [name, node] : table) {
    if (name == key) return &node;
  }
  return nullptr;
}

namespace {

/// "-0,5" with nothing behind it but a comment.
bool is_decimal_comma(std::string_view value) {
  constexpr std::string_view kDigits = "0123456789";
  value = value.substr(0, value.find('#'));
  value = value.substr(0, value.find_last_not_of(" \t\r") + 1);
  if (value.starts_with('-') || value.starts_with('+')) value.remove_prefix(1);
  const std::size_t comma = value.find(',');
  if (comma == 0 || comma == value.npos || comma + 1 == value.size()) return false;
  return value.substr(0, comma).find_first_not_of(kDigits) == value.npos &&
         value.substr(comma + 1).find_first_not_of(kDigits) == value.npos;
}

/// A backslash within double quotes.
bool has_backslash_in_quotes(std::string_view value) {
  bool quoted = false;
  for (const char c : value) {
    if (c == '"') quoted = !quoted;
    if (c == '\\' && quoted) return true;
  }
  return false;
}

/// A word or path without quotes.
bool is_bare_text(std::string_view value) {
  const auto first = static_cast<unsigned char>(value.empty() ? ' ' : value.front());
  return (std::isalpha(first) || first == '_' || first == '.' || first == '/') &&
         value.find_first_of("\"'[{") == value.npos;
}

/// Guesses what an invalid line was meant to be; empty if unknown.
std::string hint_for(std::string_view line) {
  const std::size_t equals = line.find('=');
  const std::size_t begin =
      line.find_first_not_of(" \t", equals == line.npos ? equals : equals + 1);
  if (begin == line.npos) return "";
  const std::string_view value = line.substr(begin);
  if (is_decimal_comma(value)) return "numbers have a decimal point, as in 0.5";
  if (has_backslash_in_quotes(value)) {
    return "write paths with /, or between single quotes, as in 'C:\\blocks.h5'";
  }
  return is_bare_text(value) ? "texts and paths need quotes, as in \"blocks.h5\"" : "";
}

std::string line_of(const std::string& text, std::size_t number) {
  std::istringstream lines(text);
  std::string line;
  while (number-- > 0 && std::getline(lines, line)) {
  }
  return line.substr(0, 1000);  // longer ones are no mistyped value
}

}  // namespace

TomlNode parse_toml(const std::string& text, const std::string& name) {
  check_toml_depth(text, name);
  try {
    return converted(toml::parse(text, name), SourceText(text));
  } catch (const toml::parse_error& error) {
    const std::string hint = hint_for(line_of(text, error.source().begin.line));
    throw InputError(name + ":" + std::to_string(error.source().begin.line) +
                     ": not TOML: " + std::string(error.description()) + "; " +
                     (hint.empty() ? "correct this line" : hint));
  }
}

std::string remove_backticks(std::string message) {
  std::erase(message, '`');
  return message;
}

TomlTable::TomlTable(const TomlNode& node, std::string file, std::string title,
                     std::vector<std::string> known_keys)
    : node_(&node), file_(std::move(file)), title_(std::move(title)) {
  if (node.kind != TomlNode::Kind::kTable) {
    throw InputError(file_ + ":" + std::to_string(node.line) + ": " + title_ + " = " +
                     node.source_text + ": must be a table");
  }
  for (const auto& [key, value] : node.table) {
    if (std::find(known_keys.begin(), known_keys.end(), key) != known_keys.end()) continue;
    if (title_.empty()) {
      throw InputError(file_ + ":" + std::to_string(value.line) + ": [" + key +
                       "]: unknown table; " + suggestion(key, known_keys));
    }
    refuse(key, value, "unknown key; " + suggestion(key, known_keys));
  }
}

void TomlTable::refuse(const std::string& key, const TomlNode& node,
                       const std::string& problem) const {
  throw InputError(file_ + ":" + std::to_string(node.line) + ": " + title_ +
                   (title_.empty() ? "" : " ") + escape_nonprintable(key) + " = " +
                   node.source_text + ": " + problem);
}

void TomlTable::refuse(const std::string& problem) const {
  throw InputError(file_ + ":" + std::to_string(node_->line) + ": " + title_ +
                   (title_.empty() ? "" : ": ") + problem);
}

const TomlNode& TomlTable::require_key(const std::string& key, const std::string& expected) const {
  const TomlNode* node = find(key);
  if (!node) refuse(key + " is missing; it must be " + expected);
  return *node;
}

std::optional<std::string> TomlTable::read_text(const std::string& key) const {
  const TomlNode* node = find(key);
  if (!node) return std::nullopt;
  if (node->kind != TomlNode::Kind::kString) refuse(key, *node, "must be a text in quotes");
  if (node->text.empty()) refuse(key, *node, "must not be empty");
  if (has_control_characters(node->text)) refuse(key, *node, kNoControls);
  return node->text;
}

std::optional<bool> TomlTable::read_boolean(const std::string& key) const {
  const TomlNode* node = find(key);
  if (!node) return std::nullopt;
  if (node->kind != TomlNode::Kind::kBoolean) refuse(key, *node, "must be true or false");
  return node->boolean;
}

std::optional<double> TomlTable::read_number(const std::string& key,
                                             const NumberRange& range) const {
  const TomlNode* node = find(key);
  if (!node) return std::nullopt;
  if (!node->is_number()) refuse(key, *node, "must be a number");
  if (!range.contains(node->number)) refuse(key, *node, "must be " + range.describe());
  return node->number;
}

std::optional<std::uint64_t> TomlTable::read_count(const std::string& key, std::uint64_t min_value,
                                                   std::uint64_t max_value) const {
  const TomlNode* node = find(key);
  if (!node) return std::nullopt;
  if (node->kind != TomlNode::Kind::kInteger) refuse(key, *node, "must be a whole number");
  if (node->integer < 0 || static_cast<std::uint64_t>(node->integer) < min_value ||
      static_cast<std::uint64_t>(node->integer) > max_value) {
    refuse(key, *node,
           "must be from " + std::to_string(min_value) + " to " + std::to_string(max_value));
  }
  return static_cast<std::uint64_t>(node->integer);
}

std::optional<std::vector<std::string>> TomlTable::read_text_list(const std::string& key) const {
  const TomlNode* node = find(key);
  if (!node) return std::nullopt;
  if (node->kind == TomlNode::Kind::kString) return std::vector<std::string>{*read_text(key)};
  if (node->kind != TomlNode::Kind::kList) {
    refuse(key, *node, "must be a text in quotes or a list of texts");
  }
  if (node->list.empty()) refuse(key, *node, "must not be empty");
  std::vector<std::string> values;
  for (const TomlNode& element : node->list) {
    if (element.kind != TomlNode::Kind::kString || element.text.empty()) {
      refuse(key, element, "each element must be a text in quotes, not empty");
    }
    if (has_control_characters(element.text)) refuse(key, element, kNoControls);
    values.push_back(element.text);
  }
  return values;
}

std::vector<double> TomlTable::read_numbers(const std::string& key, const TomlNode& node,
                                            std::size_t min_count, std::size_t max_count,
                                            const std::string& expected,
                                            const NumberRange& range) const {
  bool good = node.kind == TomlNode::Kind::kList && node.list.size() >= min_count &&
              node.list.size() <= max_count;
  std::vector<double> values;
  for (const TomlNode& element : node.list) {
    good = good && element.is_number();
    values.push_back(element.number);
  }
  if (!good) refuse(key, node, "must be " + expected);
  for (const double value : values) {
    if (!range.contains(value))
      refuse(key, node, "must be " + expected + ", each " + range.describe());
  }
  return values;
}

std::optional<Vec2> TomlTable::read_vec2(const std::string& key, const NumberRange& range) const {
  const TomlNode* node = find(key);
  if (!node) return std::nullopt;
  const std::vector<double> values =
      read_numbers(key, *node, 2, 2, "two finite numbers, [x, y]", range);
  return Vec2(values[0], values[1]);
}

std::optional<Vec3> TomlTable::read_vec3(const std::string& key, const NumberRange& range) const {
  const TomlNode* node = find(key);
  if (!node) return std::nullopt;
  const std::vector<double> values =
      read_numbers(key, *node, 3, 3, "three finite numbers, [x, y, z]", range);
  return Vec3(values[0], values[1], values[2]);
}

}  // namespace clast
