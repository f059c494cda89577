#pragma once
/// Checked reading of a TOML file: every refusal names file, line, key, value and what was
/// expected. toml++ stays inside the .cpp.
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

/// One value, with the line it begins on.
struct TomlNode {
  enum class Kind { kBoolean, kInteger, kFloat, kString, kList, kTable, kDate };
  Kind kind = Kind::kTable;
  std::size_t line = 1;
  std::string source_text;  ///< as in the file, on one line
  bool boolean = false;
  std::int64_t integer = 0;
  double number = 0.0;  ///< of integers too
  std::string text;
  std::vector<TomlNode> list;
  std::vector<TomlEntry> table;  ///< in order of name

  bool is_number() const { return kind == Kind::kInteger || kind == Kind::kFloat; }
  const TomlNode* find(const std::string& key) const;
};

/// A key of a table.
struct TomlEntry {
  std::string key;
  TomlNode value;
};

/// @param name  of the file, for messages
/// @throws InputError  not TOML, or nested too deep; file, line and what is wrong
TomlNode parse_toml(const std::string& text, const std::string& name);

/// The message of an error of a library, which names its fields between backticks, for a file whose
/// keys have the same names.
std::string without_backticks(std::string message);

/// One table of a file. Keys it does not know are refused at once, before a missing one is noticed,
/// so that a misspelt key is answered with its right spelling.
class TomlTable {
 public:
  /// @param title  how messages call the table, "[ground.blue]"; empty for the whole file
  TomlTable(const TomlNode& node, std::string file, std::string title,
            std::vector<std::string> known_keys);

  const TomlNode* find(const std::string& key) const { return node_->find(key); }
  const std::string& file() const { return file_; }

  /// @throws InputError  missing
  const TomlNode& required(const std::string& key, const std::string& expected) const;
  /// None when the key is absent.
  /// @throws InputError  wrong type, empty text, number out of range
  std::optional<std::string> text(const std::string& key) const;
  std::optional<bool> boolean(const std::string& key) const;
  std::optional<double> number(const std::string& key, const NumberRange& range) const;
  std::optional<std::uint64_t> count(const std::string& key, std::uint64_t least,
                                     std::uint64_t most) const;
  /// A text or a list of texts, none of them empty.
  std::optional<std::vector<std::string>> strings(const std::string& key) const;
  /// @param range  of each component
  std::optional<Vec2> vec2(const std::string& key, const NumberRange& range) const;
  std::optional<Vec3> vec3(const std::string& key, const NumberRange& range) const;

  /// The numbers of a list of `least` to `most` numbers, each in `range`; `node` is the value of
  /// `key` or lies inside it.
  std::vector<double> numbers(const std::string& key, const TomlNode& node, std::size_t least,
                              std::size_t most, const std::string& expected,
                              const NumberRange& range) const;

  /// Returns what `check` returns, and refuses the key with the message of the InputError that it
  /// throws.
  /// @param key      is there
  /// @param subject  the message begins with it
  template <class Check>
  decltype(auto) checked(const std::string& key, const Check& check,
                         const std::string& subject = "") const {
    try {
      return check();
    } catch (const InputError& error) {
      refuse(key, subject + without_backticks(error.what()));
    }
  }

  /// @throws InputError  always: "file:12: [table] key = value: must be ..."
  [[noreturn]] void refuse(const std::string& key, const TomlNode& node,
                           const std::string& problem) const;
  /// @param key  is there
  [[noreturn]] void refuse(const std::string& key, const std::string& problem) const {
    refuse(key, *find(key), problem);
  }
  /// @throws InputError  the key is there
  void refuse_if_present(const std::string& key, const std::string& problem) const {
    if (find(key)) refuse(key, problem);
  }
  /// @throws InputError  always: "file:12: [table]: ..."
  [[noreturn]] void refuse(const std::string& problem) const;

 private:
  const TomlNode* node_;
  std::string file_;
  std::string title_;
};

}  // namespace clast
