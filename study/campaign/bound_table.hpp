#pragma once
/// Tables whose keys are bound to what they set: a key is declared once, with its name, unit,
/// meaning, form and member, and what reads, explains and completes it follows.
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "study/campaign/declared_table.hpp"
#include "study/campaign/key_forms.hpp"

namespace clast::study_detail {

/// A key, and what it sets in a `Target`.
template <class Target>
struct MemberKey : TableKey {
  using Reader = std::function<void(const DeclaredTable&, Target&)>;
  Reader read;  ///< empty: the rules of the table read it, together with other keys

  MemberKey(TableKey key) : TableKey(std::move(key)) {}
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
           Reader reader = {})
      : TableKey{std::move(key), in_unit, std::move(means), with_unit(std::move(takes), in_unit)},
        read(std::move(reader)) {}

  /// Sets a member, or a member of a member: `&Campaign::stiffness, &StiffnessOptions::normal`.
  template <class Member, class... Path>
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
           Member Target::*member, Path... path)
      : MemberKey(key, in_unit, std::move(means), std::move(takes),
                 [=](const DeclaredTable& table, Target& target) {
                   table.read(key, ((target.*member).*....*path));
                 }) {}

  /// Sets a member to what the word stands for.
  template <class Meant, class... Path>
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
           Meant (*meant_by)(const std::string& word), Path... path)
      : MemberKey(key, in_unit, std::move(means), std::move(takes),
                 [=](const DeclaredTable& table, Target& target) {
                   (target.*....*path) = meant_by(*table.value<std::string>(key));
                 }) {}

  /// Sets a member to what a reader finds.
  template <class Found, class... Path>
  MemberKey(std::string key, const char* in_unit, std::string means, ValueFormat takes,
           Found (*found_in)(const DeclaredTable& table), Path... path)
      : MemberKey(std::move(key), in_unit, std::move(means), std::move(takes),
                 [=](const DeclaredTable& table, Target& target) {
                   (target.*....*path) = found_in(table);
                 }) {}
};

/// A table that fills a `Target`.
template <class Target>
struct MemberTable : KeyTable {
  std::vector<MemberKey<Target>> bound;

  /// @param about  the table without its keys
  MemberTable(KeyTable about, std::vector<MemberKey<Target>> all)
      : KeyTable(std::move(about)), bound(std::move(all)) {
    keys.assign(bound.begin(), bound.end());
  }

  /// Reads the keys that are bound, in their order.
  /// @throws InputError  one that is required is missing, or a value that its form does not allow
  void read(const DeclaredTable& table, Target& target) const {
    table.check_required();
    for (const MemberKey<Target>& key : bound) {
      if (key.read && table.find(key.name)) key.read(table, target);
    }
  }
};

}  // namespace clast::study_detail
