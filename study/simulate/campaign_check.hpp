#pragma once
/// Check of a campaign without running it.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

struct CampaignCheck {
  /// Errors: the first one of each table of the file, and those of library, terrain and starts if
  /// these could be checked. Empty if the campaign would run.
  std::vector<std::string> findings;
  std::optional<CampaignPlan> prepared;  ///< set if the campaign would run
};

/// Checks a campaign file. Errors of the campaign and of the files that it names are returned, not
/// thrown.
CampaignCheck check_campaign(const std::filesystem::path& file);
/// Checks a campaign given as text.
/// @param text, file  as `parse_campaign`
CampaignCheck check_campaign_text(const std::string& text, const std::filesystem::path& file);

}  // namespace clast
