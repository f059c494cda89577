#include "study/campaign/declared_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "study/campaign/campaign_ranges.hpp"

namespace clast::study_detail {

namespace fs = std::filesystem;

namespace {

std::string data_folder() {
  const char* variable = std::getenv("CLAST_DATA");
  const fs::path folder = variable && *variable ? fs::path(variable) : fs::path("../shared/data");
  return fs::absolute(folder).lexically_normal().string();
}

/// Adds the keys of a table, or of all tables that a value can be; each name once.
void add_keys(const ValueFormat& form, std::vector<const TableKey*>& keys) {
  for (const TableKey& key : form.keys) {
    if (std::none_of(keys.begin(), keys.end(),
                     [&](const TableKey* known) { return known->name == key.name; })) {
      keys.push_back(&key);
    }
  }
  for (const ValueFormat& item : form.items) {
    if (item.kind == ValueFormat::Kind::kTable) add_keys(item, keys);
  }
}

std::vector<std::string> names_of_keys(const std::vector<const TableKey*>& keys) {
  std::vector<std::string> names;
  for (const TableKey* key : keys) names.push_back(key->name);
  return names;
}

std::vector<const TableKey*> collect_keys(const KeyTable& declared) {
  std::vector<const TableKey*> keys;
  for (const TableKey& key : declared.keys) keys.push_back(&key);
  return keys;
}

}  // namespace

DeclaredTable::DeclaredTable(const TomlNode& node, const std::string& file,
                             const std::string& title, std::vector<const TableKey*> keys)
    : TomlTable(node, file, title, names_of_keys(keys)), title_(title), keys_(std::move(keys)) {}

DeclaredTable::DeclaredTable(const TomlNode& node, const std::string& file,
                             const std::string& title, const KeyTable& declared)
    : DeclaredTable(node, file, title, collect_keys(declared)) {}

DeclaredTable DeclaredTable::inner_table(const std::string& key) const {
  std::vector<const TableKey*> keys;
  add_keys(value_format(key), keys);
  return {*find(key), file(), title_ + " " + key, std::move(keys)};
}

const ValueFormat& DeclaredTable::value_format(const std::string& key) const {
  for (const TableKey* declared : keys_) {
    if (declared->name == key) return declared->format;
  }
  throw std::out_of_range("no key " + key + " in " + title_);
}

const TomlNode& DeclaredTable::require_key(const std::string& key) const {
  return require_key(key, value_format(key).required);
}

void DeclaredTable::check_required_keys() const {
  for (const TableKey* key : keys_) {
    if (key->is_required()) require_key(key->name);
  }
}

std::optional<std::string> DeclaredTable::word(const std::string& key) const {
  const std::vector<std::string>& words = value_format(key).innermost_format().words;
  return words.empty() ? read_text(key) : read_choice(*this, key, words);
}

std::optional<std::vector<std::string>> DeclaredTable::word_or_words(const std::string& key) const {
  const std::optional<std::vector<std::string>> names = read_text_list(key);
  const std::vector<std::string>& words = value_format(key).innermost_format().words;
  for (std::size_t i = 0; names && !words.empty() && i < names->size(); ++i) {
    if (std::find(words.begin(), words.end(), (*names)[i]) == words.end()) {
      refuse(key, element(*find(key), i), "must be of " + comma_separated(words));
    }
  }
  return names;
}

std::optional<std::vector<double>> DeclaredTable::number_or_numbers(
    const std::string& key, const NumberRange& range) const {
  const TomlNode* node = find(key);
  if (!node) return std::nullopt;
  if (node->kind != TomlNode::Kind::kList) return std::vector{*read_number(key, range)};
  const ValueFormat& list = value_format(key).items.back();
  return read_numbers(key, *node, list.minimum, list.maximum, "a number or a list of numbers",
                      range);
}

std::optional<std::vector<std::size_t>> DeclaredTable::count_or_counts(
    const std::string& key) const {
  const ValueFormat& innermost_format = value_format(key).innermost_format();
  const std::optional<std::vector<double>> numbers =
      number_or_numbers(key, {static_cast<double>(innermost_format.minimum),
                              static_cast<double>(innermost_format.maximum)});
  if (!numbers) return std::nullopt;
  for (const double value : *numbers) {
    if (value != std::floor(value)) refuse(key, *find(key), "must be whole numbers");
  }
  return std::vector<std::size_t>(numbers->begin(), numbers->end());
}

std::optional<std::vector<Vec2>> DeclaredTable::places(const std::string& key) const {
  const TomlNode* node = find(key);
  if (!node) return std::nullopt;
  const std::uint64_t minimum = value_format(key).minimum;
  if (node->kind != TomlNode::Kind::kList || node->list.size() < minimum) {
    refuse(key, "must be a list of at least " + std::to_string(minimum) + " points");
  }
  std::vector<Vec2> places;
  for (const TomlNode& row : node->list) {
    const std::vector<double> values =
        read_numbers(key, row, 2, 3, "points of finite numbers, [x, y] or [x, y, z]",
                     value_format(key).innermost_format().range);
    places.emplace_back(values[0], values[1]);
  }
  return places;
}

std::optional<fs::path> DeclaredTable::file_of(const std::string& key) const {
  if (!read_text(key)) return std::nullopt;
  return resolve_input_file(*this, key, *find(key));
}

std::optional<std::vector<fs::path>> DeclaredTable::files_of(const std::string& key) const {
  const std::optional<std::vector<std::string>> names = read_text_list(key);
  if (!names) return std::nullopt;
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < names->size(); ++i) {
    files.push_back(resolve_input_file(*this, key, element(*find(key), i)));
  }
  return files;
}

std::vector<DeclaredTable> find_tables(const TomlTable& top, const KeyTable& declared) {
  using Repeat = KeyTable::Repeat;
  const std::string one = "[" + declared.name + "]", many = "[[" + declared.name + "]]";
  const TomlNode* node = top.find(declared.name);
  if (!node) return {};
  if (declared.repeat == Repeat::kOnce ||
      (declared.repeat == Repeat::kEither && node->kind == TomlNode::Kind::kTable)) {
    return {{*node, top.file(), one, declared}};
  }
  if (node->kind != TomlNode::Kind::kList ||
      (declared.repeat == Repeat::kEither && node->list.empty())) {
    top.refuse(declared.name, *node,
               declared.repeat == Repeat::kMany
                   ? "each " + declared.name + " is a table " + many
                   : "must be a table " + one + ", or several " + many);
  }
  std::vector<DeclaredTable> tables;
  for (const TomlNode& table : node->list) {
    tables.emplace_back(table, top.file(), many, declared);
  }
  return tables;
}

DeclaredTable find_required_table(const TomlTable& top, const KeyTable& declared) {
  std::vector<DeclaredTable> tables = find_tables(top, declared);
  if (tables.empty()) {
    throw InputError(top.file() + ": the table [" + declared.name + "] is missing");
  }
  return std::move(tables.front());
}

std::optional<std::string> read_choice(const TomlTable& table, const std::string& key,
                                       const std::vector<std::string>& words) {
  const std::optional<std::string> text = table.read_text(key);
  if (text && std::find(words.begin(), words.end(), *text) == words.end()) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
      list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + ("\"" + words[i] + "\"");
    }
    table.refuse(key, "must be " + list);
  }
  return text;
}

fs::path resolve_input_file(const TomlTable& table, const std::string& key, const TomlNode& node,
                            std::string text) {
  const std::string variable = "${CLAST_DATA}";
  for (std::size_t at; (at = text.find(variable)) != std::string::npos;) {
    text.replace(at, variable.size(), data_folder());
  }
  if (text.find("${") != std::string::npos) {
    table.refuse(key, node, "only " + variable + " is replaced in paths");
  }
  const fs::path path = (fs::path(table.file()).parent_path() / text).lexically_normal();
  std::error_code code;
  if (!fs::exists(path, code)) table.refuse(key, node, "no such file: " + path.string());
  if (!fs::is_regular_file(path, code)) table.refuse(key, node, "must be a file: " + path.string());
  return path;
}

fs::path resolve_input_file(const TomlTable& table, const std::string& key, const TomlNode& node) {
  return resolve_input_file(table, key, node, node.text);
}

const TomlNode& element(const TomlNode& node, std::size_t index) {
  return node.kind == TomlNode::Kind::kList ? node.list[index] : node;
}

std::optional<Distribution> read_distribution(const TomlTable& table, const std::string& key,
                                              const NumberRange& range) {
  const TomlNode* node = table.find(key);
  if (!node) return std::nullopt;
  Distribution number;
  number.low = range.low;
  number.high = range.high;
  if (node->kind != TomlNode::Kind::kTable) {
    number.first = *table.read_number(key, range);
    return number;
  }
  const std::string expected =
      "must be a number, { uniform = [low, high] }, { normal = [mean, std] } or "
      "{ log_normal = [median, sigma] }";
  if (node->table.size() != 1) table.refuse(key, *node, expected);
  const auto& [law, value] = node->table.front();
  if (law == "uniform") {
    number.law = Distribution::Law::kUniform;
  } else if (law == "normal") {
    number.law = Distribution::Law::kNormal;
  } else if (law == "log_normal") {
    number.law = Distribution::Law::kLogNormal;
  } else {
    table.refuse(key, *node, expected);
  }
  const double maximum = std::max(range.high, kLogSigmaRange.high);
  const std::vector<double> values =
      table.read_numbers(key, value, 2, 2, "two numbers, as in " + law, {-maximum, maximum});
  number.first = values[0];
  number.second = values[1];
  if (!range.contains(number.first)) {
    table.refuse(key, *node, "its first number must be " + range.describe());
  }
  if (number.law == Distribution::Law::kUniform) {
    if (!range.contains(number.second)) {
      table.refuse(key, *node, "its second number must be " + range.describe());
    }
    if (!(number.second > number.first)) {
      table.refuse(key, *node, "the lower bound must come first");
    }
    return number;
  }
  // A wider law hardly ever draws a value inside the range.
  const NumberRange spread = number.law == Distribution::Law::kLogNormal
                                 ? kLogSigmaRange
                                 : NumberRange{range.low, range.high, range.unit};
  if (!spread.contains(number.second)) {
    table.refuse(key, *node, "its second number, the spread, must be " + spread.describe());
  }
  if (number.law == Distribution::Law::kLogNormal && !(number.first > 0.0)) {
    table.refuse(key, *node, "a median must be more than zero");
  }
  return number;
}

}  // namespace clast::study_detail
