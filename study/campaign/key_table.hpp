#pragma once
/// Declarations of TOML tables and keys. Readers and the JSON Schema are derived from them.
#include <cstdint>
#include <string>
#include <vector>

#include "core/number_range.hpp"

namespace clast {

struct TableKey;

/// Format of a value: type, words, range and length.
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
  std::string pattern = {};  ///< regular expression of texts other than `words`
  std::uint64_t minimum = 0, maximum = INT64_MAX;
  NumberRange range = {0.0, 0.0};
  std::vector<ValueFormat> items = {};
  std::vector<TableKey> keys = {};
  /// Description of the value, for the error if it is missing. If empty, the key is optional.
  std::string required = {};

  /// Returns the innermost of the first items, which has words, range and limits.
  const ValueFormat& innermost_format() const {
    return items.empty() ? *this : items.front().innermost_format();
  }
};

struct TableKey {
  std::string name;     ///< name of the key
  std::string unit;     ///< unit; empty if there is none, or if the parts state it
  std::string meaning;  ///< clause that describes the key in editors
  ValueFormat format;
  std::vector<std::string> required_with = {};  ///< if not empty, one of these keys must exist, too

  bool is_required() const { return !format.required.empty(); }
};

struct KeyTable {
  enum class Repeat {
    kOnce,    ///< [name]
    kMany,    ///< [[name]], any number
    kEither,  ///< one [name], or several [[name]]
    kNamed    ///< [name.NAME] with user-chosen names
  };
  std::string name;  ///< "blocks"; a table within another is "contact.blocks"
  std::string meaning;
  Repeat repeat = Repeat::kOnce;
  std::vector<TableKey> keys = {};
  bool required = false;
  std::vector<std::string> exactly_one_of =
      {};  ///< if not empty, exactly one of these keys must exist

  std::vector<std::string> key_names() const;
};

}  // namespace clast
