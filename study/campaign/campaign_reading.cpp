#include "study/campaign/campaign_reading.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace clast::study_detail {

PartReader findings_into(std::vector<std::string>& findings) {
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

}  // namespace clast::study_detail
