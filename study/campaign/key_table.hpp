#pragma once
/// Tables of TOML files that are written by people: their keys with unit, meaning and what each may
/// be. Readers and the JSON Schema for editors have them from the same declarations.
#include <cstdint>
#include <string>
#include <vector>

#include "core/number_range.hpp"

namespace clast {

struct TableKey;

/// What a value may be.
struct ValueFormat {
  enum class Kind {
    kText,    ///< one of `words`, or any that fits `pattern`
    kFlag,    ///< true or false
    kCount,   ///< a whole number, `least` to `most`
    kNumber,  ///< in `range`
    kList,    ///< `least` to `most` values, each of the one of `items`
    kTable,   ///< with `keys`
    kNamed,   ///< a table whose keys are names of the user's, each value of the one of `items`
    kEither   ///< one of `items`
  };
  Kind kind = Kind::kText;
  std::vector<std::string> words = {};
  std::string pattern = {};  ///< regular expression of a text that is none of `words`
  std::uint64_t least = 0, most = INT64_MAX;
  NumberRange range = {0.0, 0.0};
  std::vector<ValueFormat> items = {};
  std::vector<TableKey> keys = {};
  /// What a value that is missing must be, for its refusal; empty: it may be missing.
  std::string required = {};

  /// The words, range and limits that a value has in the first of its forms.
  const ValueFormat& leaf() const { return items.empty() ? *this : items.front().leaf(); }
};

struct TableKey {
  std::string name;
  std::string unit;     ///< empty: none, or those of the parts
  std::string meaning;  ///< a sentence's part, for who points at the key in an editor
  ValueFormat form;
  std::vector<std::string> with = {};  ///< it has a meaning only beside one of these keys

  bool is_required() const { return !form.required.empty(); }
};

struct KeyTable {
  enum class Repeat {
    kOnce,    ///< [name]
    kMany,    ///< [[name]], any number
    kEither,  ///< [name], or several [[name]]
    kNamed    ///< [name.NAME], by names of the user's
  };
  std::string name;  ///< "blocks"; a table within another is "contact.blocks"
  std::string meaning;
  Repeat repeat = Repeat::kOnce;
  std::vector<TableKey> keys = {};
  bool required = false;
  std::vector<std::string> one_of = {};  ///< exactly one of these keys is there; empty: no matter

  std::vector<std::string> key_names() const;
};

}  // namespace clast
