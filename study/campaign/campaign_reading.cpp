#include "study/campaign/campaign_reading.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace clast::study_detail {

PartReader collect_findings(std::vector<std::string>& findings) {
  return [&findings](const std::function<void()>& part) {
    try {
      part();
      return true;
    } catch (const Error& error) {
      if (std::find(findings.begin(), findings.end(), error.what()) == findings.end()) {
        findings.push_back(error.what());
      }
      return false;
    }
  };
}

TomlTable parse_top_level_table(const TomlNode& root, const std::filesystem::path& file,
                                const std::vector<KeyTable>& declared, const PartReader& read) {
  std::vector<std::string> names;
  for (const KeyTable& table : declared) {
    if (table.name.find('.') == std::string::npos) names.push_back(table.name);
  }
  read([&] { TomlTable(root, file.string(), "", names); });
  for (const auto& [name, table] : root.table) names.push_back(name);
  return {root, file.string(), "", names};
}

}  // namespace clast::study_detail
