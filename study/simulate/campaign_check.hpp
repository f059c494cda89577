#pragma once
/// Check of a campaign without running it.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

struct CampaignCheck {
  /// Errors that prevent the campaign from running. They include the first error of each table of
  /// the file, and errors of library, terrain and starts if these could be checked.
  std::vector<std::string> findings;
  std::optional<CampaignPlan> prepared;  ///< the prepared campaign; empty if there are errors
};

/// Checks a campaign file. Errors in the campaign and files that it names are returned, not thrown.
CampaignCheck check_campaign(const std::filesystem::path& file);
/// Checks a campaign given as text.
/// @param text, file  see `parse_campaign`
CampaignCheck check_campaign_text(const std::string& text, const std::filesystem::path& file);

}  // namespace clast
