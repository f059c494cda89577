#include "study/campaign/key_table.hpp"

namespace clast {

std::vector<std::string> KeyTable::key_names() const {
  std::vector<std::string> names;
  for (const TableKey& key : keys) names.push_back(key.name);
  return names;
}

}  // namespace clast
