#pragma once
/// Tables of TOML files, read as their keys are declared: each key has its words, range or limits
/// from its `ValueFormat`.
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/files/toml_reader.hpp"
#include "study/campaign/key_table.hpp"
#include "study/campaign/uncertain.hpp"

namespace clast::study_detail {

/// One table of a file.
class DeclaredTable : public TomlTable {
 public:
  /// @param title  how messages call the table, "[run]"
  /// @param keys   outlive the table
  /// @throws InputError  no table, or with a key that is not declared
  DeclaredTable(const TomlNode& node, const std::string& file, const std::string& title,
                std::vector<const TableKey*> keys);
  DeclaredTable(const TomlNode& node, const std::string& file, const std::string& title,
                const KeyTable& declared);

  /// The value of a key, which is there, as a table.
  DeclaredTable inner(const std::string& key) const;

  using TomlTable::required;
  /// @throws InputError  missing; what the key's form says that it must be
  const TomlNode& required(const std::string& key) const;
  /// @throws InputError  a key that is required is missing
  void check_required() const;

  /// None when the key is absent.
  /// @tparam Value  bool, a whole number, double, Uncertain; std::string, a path of a file that is
  ///                there; a list of numbers, texts or paths, or one of them; Vec2, Vec3; a list
  ///                of Vec2, of points whose heights are left out
  /// @throws InputError  wrong type, word or length, or a number out of range; no such file
  template <class Value>
  std::optional<Value> value(const std::string& key) const;
  /// Sets `value` where the key is there.
  template <class Value>
  void read(const std::string& key, Value& value) const {
    if (auto read = this->value<Value>(key)) value = std::move(*read);
  }
  template <class Value>
  void read(const std::string& key, std::optional<Value>& value) const {
    value = this->value<Value>(key);
  }

  const ValueFormat& form(const std::string& key) const;

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

/// The tables of this name in a file, titled as they are written: [name] or [[name]]; none when it
/// is absent.
/// @throws InputError  neither a table nor several, or with a key that is not declared
std::vector<DeclaredTable> find_tables(const TomlTable& top, const KeyTable& declared);

/// Refuses the name of a table that one of those before it has.
/// @param what  has the name, "barrier"
template <class Named>
void check_new_name(const TomlTable& table, const std::string& name,
                    const std::vector<Named>& before, const std::string& what) {
  for (const Named& other : before) {
    if (other.name == name) table.refuse("name", "another " + what + " has this name");
  }
}

/// The only table of this name.
/// @throws InputError  missing
DeclaredTable find_required_table(const TomlTable& top, const KeyTable& declared);

/// One of a few words; none when the key is absent.
std::optional<std::string> choice(const TomlTable& table, const std::string& key,
                                  const std::vector<std::string>& words);

/// A file named in a table, which must be there. Relative to the file of the table; ${CLAST_DATA}
/// is replaced.
/// @param text  the path, when `node` holds more than that
std::filesystem::path input_file(const TomlTable& table, const std::string& key,
                                 const TomlNode& node, std::string text);
std::filesystem::path input_file(const TomlTable& table, const std::string& key,
                                 const TomlNode& node);

/// The value itself where it is no list.
const TomlNode& element(const TomlNode& node, std::size_t index);

/// A number, `{ uniform = [low, high] }`, `{ normal = [mean, std] }` or
/// `{ log_normal = [median, sigma] }`, where sigma is the standard deviation of the natural
/// logarithm.
/// None when the key is absent.
/// @param range  for the number, both bounds, or mean and median
/// @throws InputError  anything else; file, line, key and value
std::optional<Distribution> read_distribution(const TomlTable& table, const std::string& key,
                                        const NumberRange& range);

template <class Value>
std::optional<Value> DeclaredTable::value(const std::string& key) const {
  const ValueFormat& leaf = form(key).leaf();
  if constexpr (std::is_same_v<Value, bool>) {
    return boolean(key);
  } else if constexpr (std::is_integral_v<Value>) {
    const std::optional<std::uint64_t> number = count(key, leaf.least, leaf.most);
    return number ? std::optional(static_cast<Value>(*number)) : std::nullopt;
  } else if constexpr (std::is_same_v<Value, double>) {
    return number(key, leaf.range);
  } else if constexpr (std::is_same_v<Value, Distribution>) {
    return read_distribution(*this, key, leaf.range);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    return word(key);
  } else if constexpr (std::is_same_v<Value, std::filesystem::path>) {
    return file_of(key);
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    return number_or_numbers(key, leaf.range);
  } else if constexpr (std::is_same_v<Value, std::vector<std::size_t>>) {
    return count_or_counts(key);
  } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
    return word_or_words(key);
  } else if constexpr (std::is_same_v<Value, std::vector<std::filesystem::path>>) {
    return files_of(key);
  } else if constexpr (std::is_same_v<Value, std::vector<Vec2>>) {
    return places(key);
  } else if constexpr (std::is_same_v<Value, Vec2>) {
    return vec2(key, leaf.range);
  } else {
    static_assert(std::is_same_v<Value, Vec3>);
    return vec3(key, leaf.range);
  }
}

}  // namespace clast::study_detail
