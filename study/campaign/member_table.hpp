#pragma once
/// TOML tables whose keys are bound to data members. Each key is declared once with name, unit,
/// meaning, format and member.
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "study/campaign/declared_table.hpp"
#include "study/campaign/value_formats.hpp"

namespace clast::study_detail {

/// Declared key together with the reader that stores its value in a `Target`.
template <class Target>
struct MemberKey : TableKey {
  using Reader = std::function<void(const DeclaredTable&, Target&)>;
  Reader read;  ///< empty if the reader of another key stores this value

  MemberKey(TableKey key) : TableKey(std::move(key)) {}
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
            Reader reader = {})
      : TableKey{std::move(key), in_unit, std::move(means), with_unit(std::move(takes), in_unit)},
        read(std::move(reader)) {}

  /// Stores the value in a data member, such as `&Campaign::stiffness, &StiffnessOptions::normal`.
  template <class Member, class... Path>
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
            Member Target::*member, Path... path)
      : MemberKey(key, in_unit, std::move(means), std::move(takes),
                  [=](const DeclaredTable& table, Target& target) {
                    table.read(key, ((target.*member).*....*path));
                  }) {}

  /// Stores the value returned by `parse_word` for the text.
  template <class Meant, class... Path>
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
            Meant (*parse_word)(const std::string& word), Path... path)
      : MemberKey(key, in_unit, std::move(means), std::move(takes),
                  [=](const DeclaredTable& table, Target& target) {
                    (target.*....*path) = parse_word(*table.value<std::string>(key));
                  }) {}

  /// Stores the value that `read_value` returns.
  template <class Found, class... Path>
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
            Found (*read_value)(const DeclaredTable& table), Path... path)
      : MemberKey(std::move(key), in_unit, std::move(means), std::move(takes),
                  [=](const DeclaredTable& table, Target& target) {
                    (target.*....*path) = read_value(table);
                  }) {}
};

/// Declared table whose keys fill a `Target`.
template <class Target>
struct MemberTable : KeyTable {
  std::vector<MemberKey<Target>> bound_keys;

  /// Makes a table from its declaration and its keys.
  /// @param about  declaration of the table without its keys
  MemberTable(KeyTable about, std::vector<MemberKey<Target>> all)
      : KeyTable(std::move(about)), bound_keys(std::move(all)) {
    keys.assign(bound_keys.begin(), bound_keys.end());
  }

  /// Reads all bound keys in their order.
  /// @throws InputError  if a required key is missing or a value violates its format
  void read(const DeclaredTable& table, Target& target) const {
    table.check_required_keys();
    for (const MemberKey<Target>& key : bound_keys) {
      if (key.read && table.find(key.name)) key.read(table, target);
    }
  }
};

}  // namespace clast::study_detail
