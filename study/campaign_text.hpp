#pragma once
/// Campaigns that are in no file, or not as they are in one: made or changed by a program.
#include <filesystem>
#include <string>

#include "study/campaign_check.hpp"

namespace clast {

/// As `read_campaign` of a file that holds `text`.
/// @param file  that the text could be in: its folder is the one that paths in the text start from,
///              and messages name it. It need not be there.
/// @throws InputError  as `read_campaign`
Campaign parse_campaign(const std::string& text, const std::filesystem::path& file);

/// As `check_campaign` of a file that holds `text`.
CampaignCheck check_campaign_text(const std::string& text, const std::filesystem::path& file);

}  // namespace clast
