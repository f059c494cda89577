#pragma once
/// Whether a campaign would run.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// What `prepare_campaign` would make of a campaign file.
struct CampaignCheck {
  /// Why it would be refused: the first finding in each table of the file, and in library, terrain
  /// and starts where these can be judged. Empty: it would run.
  std::vector<std::string> findings;
  std::optional<CampaignPlan> prepared;  ///< there when it would run
};

/// Never throws for what is wrong with the campaign or with the files it names.
CampaignCheck check_campaign(const std::filesystem::path& file);
/// Checks a campaign that is not in a file.
/// @param text, file  as `parse_campaign`
CampaignCheck check_campaign_text(const std::string& text, const std::filesystem::path& file);

}  // namespace clast
