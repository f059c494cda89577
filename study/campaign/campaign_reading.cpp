#include "study/campaign/campaign_reading.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/error.hpp"
#include "study/campaign/campaign_keys.hpp"
#include "study/campaign/campaign_ranges.hpp"

namespace clast::study_detail {

namespace fs = std::filesystem;

namespace {

std::string data_folder() {
  const char* variable = std::getenv("CLAST_DATA");
  const fs::path folder = variable && *variable ? fs::path(variable) : fs::path("../shared/data");
  return fs::absolute(folder).lexically_normal().string();
}

}  // namespace

PartReader findings_into(std::vector<std::string>& findings) {
  return [&findings](const std::function<void()>& part) {
    try {
      part();
      return true;
    } catch (const Error& error) {
      if (std::find(findings.begin(), findings.end(), error.what()) == findings.end()) {
        findings.push_back(error.what());
      }
      return false;
    }
  };
}

fs::path input_file(const TomlTable& table, const std::string& key, const TomlNode& node,
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

fs::path input_file(const TomlTable& table, const std::string& key, const TomlNode& node) {
  return input_file(table, key, node, node.text);
}

const TomlNode& element(const TomlNode& node, std::size_t index) {
  return node.kind == TomlNode::Kind::kList ? node.list[index] : node;
}

std::optional<std::string> campaign_choice(const TomlTable& table, const std::string& name,
                                           const std::string& key) {
  return choice(table, key, campaign_words(name, key));
}

std::optional<std::string> choice(const TomlTable& table, const std::string& key,
                                  const std::vector<std::string>& words) {
  const std::optional<std::string> text = table.text(key);
  if (text && std::find(words.begin(), words.end(), *text) == words.end()) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
      list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + ("\"" + words[i] + "\"");
    }
    table.refuse(key, *table.find(key), "must be " + list);
  }
  return text;
}

TomlTable required_table(const TomlTable& top, const std::string& name) {
  const TomlNode* node = top.find(name);
  if (!node) {
    throw InputError(top.file() + ": the table [" + name + "] is missing");
  }
  return {*node, top.file(), "[" + name + "]", campaign_keys(name)};
}

std::vector<const TomlNode*> tables_of(const TomlTable& top, const std::string& name) {
  std::vector<const TomlNode*> tables;
  const TomlNode* node = top.find(name);
  if (!node) return tables;
  if (node->kind == TomlNode::Kind::kTable) return {node};
  if (node->kind != TomlNode::Kind::kList || node->list.empty()) {
    top.refuse(name, *node, "must be a table [" + name + "], or several [[" + name + "]]");
  }
  for (const TomlNode& table : node->list) tables.push_back(&table);
  return tables;
}

std::optional<Uncertain> read_uncertain(const TomlTable& table, const std::string& key,
                                        const NumberRange& range) {
  const TomlNode* node = table.find(key);
  if (!node) return std::nullopt;
  Uncertain number;
  number.low = range.low;
  number.high = range.high;
  if (node->kind != TomlNode::Kind::kTable) {
    number.first = *table.number(key, range);
    return number;
  }
  const std::string expected =
      "must be a number, { uniform = [low, high] }, { normal = [mean, std] } or "
      "{ log_normal = [median, sigma] }";
  if (node->table.size() != 1) table.refuse(key, *node, expected);
  const auto& [law, value] = node->table.front();
  if (law == "uniform") {
    number.law = Uncertain::Law::kUniform;
  } else if (law == "normal") {
    number.law = Uncertain::Law::kNormal;
  } else if (law == "log_normal") {
    number.law = Uncertain::Law::kLogNormal;
  } else {
    table.refuse(key, *node, expected);
  }
  const double most = std::max(range.high, kLogSigma.high);
  const std::vector<double> values =
      table.numbers(key, value, 2, 2, "two numbers, as in " + law, {-most, most});
  number.first = values[0];
  number.second = values[1];
  if (!range.holds(number.first)) {
    table.refuse(key, *node, "its first number must be " + range.words());
  }
  if (number.law == Uncertain::Law::kUniform) {
    if (!range.holds(number.second)) {
      table.refuse(key, *node, "its second number must be " + range.words());
    }
    if (!(number.second > number.first)) {
      table.refuse(key, *node, "the lower bound must come first");
    }
    return number;
  }
  // A wider law hardly ever draws a value inside the range.
  const NumberRange spread = number.law == Uncertain::Law::kLogNormal
                                 ? kLogSigma
                                 : NumberRange{range.low, range.high, range.unit};
  if (!spread.holds(number.second)) {
    table.refuse(key, *node, "its second number, the spread, must be " + spread.words());
  }
  if (number.law == Uncertain::Law::kLogNormal && !(number.first > 0.0)) {
    table.refuse(key, *node, "a median must be more than zero");
  }
  return number;
}

}  // namespace clast::study_detail
