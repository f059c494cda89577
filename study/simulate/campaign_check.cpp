#include "study/simulate/campaign_check.hpp"

#include "core/error.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/simulate/ground_sets.hpp"

namespace clast {

using namespace study_detail;

namespace {

CampaignCheck check(const std::filesystem::path& file, const std::optional<std::string>& text) {
  CampaignCheck result;
  std::vector<std::string>& findings = result.findings;
  const PartReader read = collect_findings(findings);
  const Campaign campaign = read_campaign_by_parts(file, text, read);
  if (findings.empty() && read([&] { result.prepared.emplace(prepare_campaign(campaign)); }))
    return result;
  // Library and terrain are judged each by itself.
  if (!campaign.blocks.library.empty()) read([&] { choose_campaign_blocks(campaign); });
  if (!campaign.terrain.surface.empty()) {
    read([&] {
      const Terrain terrain = read_terrain(campaign.terrain);
      if (!campaign.ground.empty()) sample_ground_sets(campaign, terrain.zone_names);
    });
  }
  return result;
}

}  // namespace

CampaignCheck check_campaign(const std::filesystem::path& file) {
  return check(file, std::nullopt);
}

CampaignCheck check_campaign_text(const std::string& text, const std::filesystem::path& file) {
  return check(file, text);
}

}  // namespace clast
