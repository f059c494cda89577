#pragma once
/// Declarations of TOML tables and keys. Readers and the JSON Schema are derived from them.
#include <cstdint>
#include <string>
#include <vector>

#include "core/number_range.hpp"

namespace clast {

struct TableKey;

/// Declared format of a TOML value: type, allowed words, range and length.
struct ValueFormat {
  enum class Kind {
    kText,    ///< one of `words`, or a text that matches `pattern`
    kFlag,    ///< true or false
    kCount,   ///< an integer from `least` to `most`
    kNumber,  ///< a number in `range`
    kList,    ///< `least` to `most` values of format `items[0]`
    kTable,   ///< a table with `keys`
    kNamed,   ///< [name.NAME] with user-chosen names
    kEither   ///< [name] or several [[name]]
  };
  Kind kind = Kind::kText;
  std::vector<std::string> words = {};
  std::string pattern = {};  ///< regular expression of allowed texts other than `words`
  std::uint64_t minimum = 0, maximum = INT64_MAX;
  NumberRange range = {0.0, 0.0};
  std::vector<ValueFormat> items = {};
  std::vector<TableKey> keys = {};
  /// Description of the value in the message if it is missing. If empty, the key is optional.
  std::string required = {};

  /// Returns the format of the innermost list items, or this format if it has no items.
  const ValueFormat& innermost_format() const {
    return items.empty() ? *this : items.front().innermost_format();
  }
};

struct TableKey {
  std::string name;     ///< name of the key
  std::string unit;     ///< unit of the value; may be empty
  std::string meaning;  ///< clause that describes the key in editors
  ValueFormat format;
  /// Keys of which one must exist as well; empty if none is needed.
  std::vector<std::string> required_with = {};

  bool is_required() const { return !format.required.empty(); }
};

struct KeyTable {
  enum class Repeat {
    kOnce,    ///< [name]
    kMany,    ///< [[name]], any number
    kEither,  ///< one [name], or several [[name]]
    kNamed    ///< [name.NAME] with user-chosen names
  };
  std::string name;  ///< name of the table, such as "blocks" or "contact.blocks"
  std::string meaning;
  Repeat repeat = Repeat::kOnce;
  std::vector<TableKey> keys = {};
  bool required = false;
  /// Keys of which exactly one must exist; may be empty.
  std::vector<std::string> exactly_one_of = {};

  std::vector<std::string> key_names() const;
};

}  // namespace clast
