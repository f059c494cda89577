#include "study/campaign/key_table.hpp"

#include <stdexcept>

namespace clast {

const std::vector<std::string>& TableKey::words() const {
  for (const ValueForm& form : forms) {
    if (!form.words.empty()) return form.words;
  }
  throw std::out_of_range("no words for key " + name);
}

std::vector<std::string> KeyTable::key_names() const {
  std::vector<std::string> names;
  for (const TableKey& key : keys) names.push_back(key.name);
  return names;
}

const TableKey& KeyTable::key(const std::string& wanted) const {
  for (const TableKey& key : keys) {
    if (key.name == wanted) return key;
  }
  throw std::out_of_range("no key " + wanted + " in table " + name);
}

const KeyTable& table_named(const std::vector<KeyTable>& tables, const std::string& name) {
  for (const KeyTable& table : tables) {
    if (table.name == name) return table;
  }
  throw std::out_of_range("no table " + name);
}

}  // namespace clast
