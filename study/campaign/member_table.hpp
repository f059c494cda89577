#pragma once
/// TOML tables whose keys are bound to data members of a struct.
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "study/campaign/declared_table.hpp"
#include "study/campaign/value_formats.hpp"

namespace clast::study_detail {

/// Declared TOML key with a function that stores its value in a struct.
template <class Target>
struct MemberKey : TableKey {
  using Reader = std::function<void(const DeclaredTable&, Target&)>;
  Reader read;  ///< function that stores the value; empty if another key does this

  MemberKey(TableKey key) : TableKey(std::move(key)) {}
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
            Reader reader = {})
      : TableKey{std::move(key), in_unit, std::move(means), with_unit(std::move(takes), in_unit)},
        read(std::move(reader)) {}

  /// Makes a key whose value is stored in a data member, or in a member of a member.
  template <class Member, class... Path>
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
            Member Target::*member, Path... path)
      : MemberKey(key, in_unit, std::move(means), std::move(takes),
                  [=](const DeclaredTable& table, Target& target) {
                    table.read(key, ((target.*member).*....*path));
                  }) {}

  /// Makes a key whose text is converted by `parse_word` before it is stored.
  template <class Meant, class... Path>
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
            Meant (*parse_word)(const std::string& word), Path... path)
      : MemberKey(key, in_unit, std::move(means), std::move(takes),
                  [=](const DeclaredTable& table, Target& target) {
                    (target.*....*path) = parse_word(*table.value<std::string>(key));
                  }) {}

  /// Makes a key whose value is read from the table by `read_value` before it is stored.
  template <class Found, class... Path>
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
            Found (*read_value)(const DeclaredTable& table), Path... path)
      : MemberKey(std::move(key), in_unit, std::move(means), std::move(takes),
                  [=](const DeclaredTable& table, Target& target) {
                    (target.*....*path) = read_value(table);
                  }) {}
};

/// Declared TOML table whose keys fill the data members of a struct.
template <class Target>
struct MemberTable : KeyTable {
  std::vector<MemberKey<Target>> bound_keys;

  /// Makes a table from its declaration and its bound keys.
  /// @param about  declaration of the table, without keys
  MemberTable(KeyTable about, std::vector<MemberKey<Target>> all)
      : KeyTable(std::move(about)), bound_keys(std::move(all)) {
    keys.assign(bound_keys.begin(), bound_keys.end());
  }

  /// Reads all bound keys of a table into `target`.
  /// @throws InputError  if a required key is missing or a value violates its format
  void read(const DeclaredTable& table, Target& target) const {
    table.check_required_keys();
    for (const MemberKey<Target>& key : bound_keys) {
      if (key.read && table.find(key.name)) key.read(table, target);
    }
  }
};

}  // namespace clast::study_detail
