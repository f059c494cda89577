#include "study/calibrate/detail/study_reading.hpp"

#include <algorithm>

#include "core/listed.hpp"
#include "study/calibrate/study_keys.hpp"

namespace clast::study_detail {
namespace {

std::string title(const KeyTable& table) {
  return table.repeat == KeyTable::Repeat::kOnce ? "[" + table.name + "]"
                                                 : "[[" + table.name + "]]";
}

}  // namespace

StudyTable::StudyTable(const TomlNode& node, const std::string& file, const std::string& name)
    : TomlTable(node, file, title(table_named(calibration_tables(), name)),
                table_named(calibration_tables(), name).key_names()),
      declared_(&table_named(calibration_tables(), name)) {}

std::optional<std::uint64_t> StudyTable::count_of(const std::string& key) const {
  const ValueForm& form = declared_->key(key).forms.front();
  return count(key, form.least, form.most);
}

std::optional<std::string> StudyTable::choice_of(const std::string& key) const {
  return choice(*this, key, declared_->key(key).words());
}

std::vector<double> StudyTable::numbers_of(const std::string& key,
                                           const std::string& expected) const {
  const ValueForm& form = declared_->key(key).forms.front();
  return numbers(key, required(key, expected), form.least, form.most, expected,
                 form.items.front().range);
}

std::string StudyTable::source(const std::string& missing) const {
  std::string source;
  for (const std::string& one : declared_->one_of) {
    if (!find(one)) continue;
    if (!source.empty()) refuse("has " + source + " and " + one + "; write two observations");
    source = one;
  }
  if (source.empty()) refuse(missing);
  for (const TableKey& key : declared_->keys) {
    const TomlNode* node = find(key.name);
    if (!node || key.with.empty() ||
        std::find(key.with.begin(), key.with.end(), source) != key.with.end()) {
      continue;
    }
    refuse(key.name, *node,
           "belongs to an observation with " + listed(key.with) + "; leave it out here");
  }
  return source;
}

}  // namespace clast::study_detail
