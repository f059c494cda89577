#pragma once
/// How far blocks of a proposed campaign go.
#include "study/campaign_runner.hpp"
#include "study/new_campaign.hpp"

namespace clast::study_detail {

/// Runs a few releases of the proposed campaign. Where hardly any passes the barrier, which is its
/// first, it is placed where half of them have passed; a doubt says what they did.
void try_campaign(const PreparedCampaign& prepared, CampaignProposal& proposal);

}  // namespace clast::study_detail
