#pragma once
/// Reading of TOML tables by the declared formats of their keys.
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/files/toml_reader.hpp"
#include "study/campaign/distribution.hpp"
#include "study/campaign/key_table.hpp"

namespace clast::study_detail {

/// TOML table in which each key is declared with a `ValueFormat`.
class DeclaredTable : public TomlTable {
 public:
  /// Makes the table and checks its keys.
  /// @param title  name of the table in messages, such as "[run]"
  /// @param keys  declarations of the keys; must outlive the table
  /// @throws InputError  if `node` is not a table or has an undeclared key
  DeclaredTable(const TomlNode& node, const std::string& file, const std::string& title,
                std::vector<const TableKey*> keys);
  DeclaredTable(const TomlNode& node, const std::string& file, const std::string& title,
                const KeyTable& declared);

  /// Returns the table that is the value of an existing key.
  DeclaredTable inner_table(const std::string& key) const;

  using TomlTable::require_key;
  /// Returns the node of a required key.
  /// @throws InputError  if the key is missing; states the expected value
  const TomlNode& require_key(const std::string& key) const;
  /// Checks that all required keys exist.
  /// @throws InputError  if one is missing
  void check_required_keys() const;

  /// Reads a value by its declared format; empty if the key is absent.
  /// @tparam Value  bool, an integer, double, Distribution, std::string, path of an existing file,
  ///                Vec2, Vec3, a vector of numbers, texts or paths (also from a single one), or a
  ///                vector of Vec2 (heights are ignored)
  /// @throws InputError  if the type, word, length or range is wrong, or the file does not exist
  template <class Value>
  std::optional<Value> value(const std::string& key) const;
  /// Stores the value if the key exists.
  template <class Value>
  void read(const std::string& key, Value& value) const {
    if (auto read = this->value<Value>(key)) value = std::move(*read);
  }
  template <class Value>
  void read(const std::string& key, std::optional<Value>& value) const {
    value = this->value<Value>(key);
  }

  const ValueFormat& value_format(const std::string& key) const;

 private:
  std::optional<std::string> word(const std::string& key) const;
  std::optional<std::vector<std::string>> word_or_words(const std::string& key) const;
  std::optional<std::vector<double>> number_or_numbers(const std::string& key,
                                                       const NumberRange& range) const;
  std::optional<std::vector<std::size_t>> count_or_counts(const std::string& key) const;
  std::optional<std::vector<Vec2>> places(const std::string& key) const;
  std::optional<std::filesystem::path> file_of(const std::string& key) const;
  std::optional<std::vector<std::filesystem::path>> files_of(const std::string& key) const;

  std::string title_;
  std::vector<const TableKey*> keys_;
};

/// Finds the tables of one name: [name], or several [[name]]. Empty if there is none.
/// @throws InputError  if the value is not a table or a list of tables, or a key is undeclared
std::vector<DeclaredTable> find_tables(const TomlTable& top, const KeyTable& declared);

/// Checks that no earlier table has the same value of the key "name".
/// @param what  kind of table for the message, such as "barrier"
template <class Named>
void check_unique_name(const TomlTable& table, const std::string& name,
                       const std::vector<Named>& before, const std::string& what) {
  for (const Named& other : before) {
    if (other.name == name) table.refuse("name", "another " + what + " has this name");
  }
}

/// Finds the single table of one name.
/// @throws InputError  if it is missing
DeclaredTable find_required_table(const TomlTable& top, const KeyTable& declared);

/// Reads the value of a key that is one of the given words; empty if the key is absent.
std::optional<std::string> read_choice(const TomlTable& table, const std::string& key,
                                       const std::vector<std::string>& words);

/// Resolves the path of an existing file. Relative paths refer to the folder of the TOML file.
/// ${CLAST_DATA} is replaced.
/// @param text  path as written in the file
std::filesystem::path resolve_input_file(const TomlTable& table, const std::string& key,
                                         const TomlNode& node, std::string text);
std::filesystem::path resolve_input_file(const TomlTable& table, const std::string& key,
                                         const TomlNode& node);

/// Returns an element of a TOML list, or `node` itself if it is not a list.
const TomlNode& element(const TomlNode& node, std::size_t index);

/// Reads a number or distribution: `{ uniform = [low, high] }`, `{ normal = [mean, std] }` or `{
/// log_normal = [median, sigma] }`, where sigma is the standard deviation of the natural logarithm.
/// Empty if the key is absent.
/// @param range  allowed range of the number, the bounds, the mean or the median
/// @throws InputError  if the value is invalid; names file, line, key and value
std::optional<Distribution> read_distribution(const TomlTable& table, const std::string& key,
                                              const NumberRange& range);

template <class Value>
std::optional<Value> DeclaredTable::value(const std::string& key) const {
  const ValueFormat& innermost_format = value_format(key).innermost_format();
  if constexpr (std::is_same_v<Value, bool>) {
    return read_boolean(key);
  } else if constexpr (std::is_integral_v<Value>) {
    const std::optional<std::uint64_t> number =
        read_count(key, innermost_format.minimum, innermost_format.maximum);
    return number ? std::optional(static_cast<Value>(*number)) : std::nullopt;
  } else if constexpr (std::is_same_v<Value, double>) {
    return read_number(key, innermost_format.range);
  } else if constexpr (std::is_same_v<Value, Distribution>) {
    return read_distribution(*this, key, innermost_format.range);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    return word(key);
  } else if constexpr (std::is_same_v<Value, std::filesystem::path>) {
    return file_of(key);
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    return number_or_numbers(key, innermost_format.range);
  } else if constexpr (std::is_same_v<Value, std::vector<std::size_t>>) {
    return count_or_counts(key);
  } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
    return word_or_words(key);
  } else if constexpr (std::is_same_v<Value, std::vector<std::filesystem::path>>) {
    return files_of(key);
  } else if constexpr (std::is_same_v<Value, std::vector<Vec2>>) {
    return places(key);
  } else if constexpr (std::is_same_v<Value, Vec2>) {
    return read_vec2(key, innermost_format.range);
  } else {
    static_assert(std::is_same_v<Value, Vec3>);
    return read_vec3(key, innermost_format.range);
  }
}

}  // namespace clast::study_detail
