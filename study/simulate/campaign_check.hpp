#pragma once
/// Check of a campaign without running it.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

struct CampaignCheck {
  /// Errors of campaign file, library, terrain and starts, which prevent the campaign from running.
  std::vector<std::string> findings;
  std::optional<CampaignPlan> prepared;  ///< prepared campaign; empty if there are errors
};

/// Checks a campaign file. Errors in the campaign and files that it names are returned, not thrown.
CampaignCheck check_campaign(const std::filesystem::path& file);
/// Checks a campaign given as text.
/// @param text, file  text and path of the campaign, as for `parse_campaign`
CampaignCheck check_campaign_text(const std::string& text, const std::filesystem::path& file);

}  // namespace clast
