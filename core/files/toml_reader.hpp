#pragma once
/// Checked reading of TOML files. Error messages name file, line, key, value and expected value.
/// toml++ is used in the .cpp file only.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/number_range.hpp"
#include "core/types.hpp"

namespace clast {

struct TomlEntry;

/// TOML value, with the number of its first line.
struct TomlNode {
  enum class Kind { kBoolean, kInteger, kFloat, kString, kList, kTable, kDate };
  Kind kind = Kind::kTable;
  std::size_t line = 1;
  std::string source_text;  ///< text of the value in the file, on one line
  bool boolean = false;
  std::int64_t integer = 0;
  double number = 0.0;  ///< also for integers
  std::string text;
  std::vector<TomlNode> list;
  std::vector<TomlEntry> table;  ///< ordered by name

  bool is_number() const { return kind == Kind::kInteger || kind == Kind::kFloat; }
  const TomlNode* find(const std::string& key) const;
};

/// Entry of a TOML table: key and value.
struct TomlEntry {
  std::string key;
  TomlNode value;
};

/// Parses a TOML text.
/// @param name  name of the file, for messages
/// @throws InputError  if the text is not TOML or nested too deep; names file, line and problem
TomlNode parse_toml(const std::string& text, const std::string& name);

/// Removes the backticks around field names in a message, for files with equal key names.
std::string remove_backticks(std::string message);

/// TOML table with checked reading of its values. Unknown keys are reported before missing ones, so
/// that the message for a misspelt key suggests the correct one.
class TomlTable {
 public:
  /// Constructs a table and checks its keys.
  /// @param title  name in messages, "[ground.blue]"; empty for the whole file
  TomlTable(const TomlNode& node, std::string file, std::string title,
            std::vector<std::string> known_keys);

  const TomlNode* find(const std::string& key) const { return node_->find(key); }
  const std::string& file() const { return file_; }

  /// Returns the value of a required key.
  /// @throws InputError  if it is missing
  const TomlNode& require_key(const std::string& key, const std::string& expected) const;
  /// Reads a text; empty if the key is absent. The other `read_` functions behave likewise.
  /// @throws InputError  if the value has the wrong type, is an empty text, or is out of range
  std::optional<std::string> read_text(const std::string& key) const;
  std::optional<bool> read_boolean(const std::string& key) const;
  std::optional<double> read_number(const std::string& key, const NumberRange& range) const;
  std::optional<std::uint64_t> read_count(const std::string& key, std::uint64_t min_value,
                                          std::uint64_t max_value) const;
  /// Reads a text or a list of texts, none of them empty.
  std::optional<std::vector<std::string>> read_text_list(const std::string& key) const;
  /// Reads a vector with finite components.
  /// @param range  allowed range of each component
  std::optional<Vec2> read_vec2(const std::string& key, const NumberRange& range) const;
  std::optional<Vec3> read_vec3(const std::string& key, const NumberRange& range) const;

  /// Reads a list of `min_count` to `max_count` numbers in `range`. `node` is the value of `key`,
  /// or an element of it.
  std::vector<double> read_numbers(const std::string& key, const TomlNode& node,
                                   std::size_t min_count, std::size_t max_count,
                                   const std::string& expected, const NumberRange& range) const;

  /// Calls `check` and returns its result. If it throws an InputError, the error is thrown again
  /// with file, line and key in its message.
  /// @param key  must exist
  /// @param subject  start of the message
  template <class Check>
  decltype(auto) run_check(const std::string& key, const Check& check,
                           const std::string& subject = "") const {
    try {
      return check();
    } catch (const InputError& error) {
      refuse(key, subject + remove_backticks(error.what()));
    }
  }

  /// Throws the error for an invalid value of a key.
  /// @throws InputError  always: "file:12: [table] key = value: must be ..."
  [[noreturn]] void refuse(const std::string& key, const TomlNode& node,
                           const std::string& problem) const;
  /// Throws the error for an invalid value of a key that exists.
  [[noreturn]] void refuse(const std::string& key, const std::string& problem) const {
    refuse(key, *find(key), problem);
  }
  /// Throws an error if a key exists.
  /// @throws InputError  if the key exists
  void refuse_if_present(const std::string& key, const std::string& problem) const {
    if (find(key)) refuse(key, problem);
  }
  /// Throws the error for an invalid table.
  /// @throws InputError  always: "file:12: [table]: ..."
  [[noreturn]] void refuse(const std::string& problem) const;

 private:
  const TomlNode* node_;
  std::string file_;
  std::string title_;
};

}  // namespace clast
