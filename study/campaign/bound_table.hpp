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
struct BoundKey : TableKey {
  using Reader = std::function<void(const DeclaredTable&, Target&)>;
  Reader read;  ///< empty: the rules of the table read it, together with other keys

  BoundKey(TableKey key) : TableKey(std::move(key)) {}
  BoundKey(std::string key, const char* in_unit, std::string means, ValueForm takes,
           Reader reader = {})
      : TableKey{std::move(key), in_unit, std::move(means), with_unit(std::move(takes), in_unit)},
        read(std::move(reader)) {}

  /// Sets a member, or a member of a member: `&Campaign::stiffness, &StiffnessOptions::normal`.
  template <class Member, class... Path>
  BoundKey(std::string key, const char* in_unit, std::string means, ValueForm takes,
           Member Target::*member, Path... path)
      : BoundKey(key, in_unit, std::move(means), std::move(takes),
                 [=](const DeclaredTable& table, Target& target) {
                   table.read(key, ((target.*member).*....*path));
                 }) {}

  /// Sets a member to what the word stands for.
  template <class Meant, class... Path>
  BoundKey(std::string key, const char* in_unit, std::string means, ValueForm takes,
           Meant (*meant_by)(const std::string& word), Path... path)
      : BoundKey(key, in_unit, std::move(means), std::move(takes),
                 [=](const DeclaredTable& table, Target& target) {
                   (target.*....*path) = meant_by(*table.value<std::string>(key));
                 }) {}

  /// Sets a member to what a reader finds.
  template <class Found, class... Path>
  BoundKey(std::string key, const char* in_unit, std::string means, ValueForm takes,
           Found (*found_in)(const DeclaredTable& table), Path... path)
      : BoundKey(std::move(key), in_unit, std::move(means), std::move(takes),
                 [=](const DeclaredTable& table, Target& target) {
                   (target.*....*path) = found_in(table);
                 }) {}
};

/// A table that fills a `Target`.
template <class Target>
struct BoundTable : KeyTable {
  std::vector<BoundKey<Target>> bound;

  /// @param about  the table without its keys
  BoundTable(KeyTable about, std::vector<BoundKey<Target>> all)
      : KeyTable(std::move(about)), bound(std::move(all)) {
    keys.assign(bound.begin(), bound.end());
  }

  /// Reads the keys that are bound, in their order.
  /// @throws InputError  one that is required is missing, or a value that its form does not allow
  void read(const DeclaredTable& table, Target& target) const {
    table.check_required();
    for (const BoundKey<Target>& key : bound) {
      if (key.read && table.find(key.name)) key.read(table, target);
    }
  }
};

}  // namespace clast::study_detail
