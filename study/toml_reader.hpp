#pragma once
/// Checked reading of a TOML file: every refusal names file, line, key, value and what was
/// expected. toml++ stays inside the .cpp.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace clast {

/// One value, with the line it begins on.
struct TomlNode {
  enum class Kind { kBoolean, kInteger, kFloat, kString, kList, kTable, kDate };
  Kind kind = Kind::kTable;
  std::size_t line = 1;
  std::string written;  ///< as in the file, on one line
  bool boolean = false;
  std::int64_t integer = 0;
  double number = 0.0;  ///< of integers too
  std::string text;
  std::vector<TomlNode> list;
  std::vector<std::pair<std::string, TomlNode>> table;  ///< in order of name

  bool is_number() const { return kind == Kind::kInteger || kind == Kind::kFloat; }
  const TomlNode* find(const std::string& key) const;
};

/// @param name  of the file, for messages
/// @throws InputError  not TOML; file, line and what is wrong
TomlNode parse_toml(const std::string& text, const std::string& name);

/// What a number must be; bounds and the words for it.
struct NumberRange {
  double low;
  bool low_included;
  double high;
  const char* expected;  ///< completes "must be ..."
};

/// Finite and in the range.
bool in_range(double value, const NumberRange& range);

inline constexpr double kLargestNumber = 1e300;
inline constexpr NumberRange kFinite{-kLargestNumber, true, kLargestNumber, "a finite number"};
inline constexpr NumberRange kPositive{0.0, false, kLargestNumber, "more than zero"};
inline constexpr NumberRange kNotNegative{0.0, true, kLargestNumber, "zero or more"};
inline constexpr NumberRange kShare{0.0, false, 1.0, "more than zero and at most 1"};

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
  /// @throws InputError  wrong type, empty text, number not finite or out of range
  std::optional<std::string> text(const std::string& key) const;
  std::optional<double> number(const std::string& key, const NumberRange& range) const;
  std::optional<std::uint64_t> count(const std::string& key, std::uint64_t least,
                                     std::uint64_t most) const;
  /// A text or a list of texts, none of them empty.
  std::optional<std::vector<std::string>> texts(const std::string& key) const;
  std::optional<Vec2> vec2(const std::string& key) const;
  std::optional<Vec3> vec3(const std::string& key) const;

  /// The numbers of a list of `least` to `most` finite numbers; `node` is the value of `key` or
  /// lies inside it.
  std::vector<double> numbers(const std::string& key, const TomlNode& node, std::size_t least,
                              std::size_t most, const std::string& expected) const;

  /// @throws InputError  always: "file:12: [table] key = value: must be ..."
  [[noreturn]] void refuse(const std::string& key, const TomlNode& node,
                           const std::string& problem) const;
  /// @throws InputError  always: "file:12: [table]: ..."
  [[noreturn]] void refuse(const std::string& problem) const;

 private:
  const TomlNode* node_;
  std::string file_;
  std::string title_;
};

}  // namespace clast
