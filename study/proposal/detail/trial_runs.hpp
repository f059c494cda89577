#pragma once
/// How far blocks of a proposed campaign go.
#include "study/proposal/new_campaign.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Runs a few releases of the proposed campaign and records what they did.
void run_trials(const PreparedCampaign& prepared, CampaignProposal& proposal);
/// Where hardly any of them passes the barrier, which is the campaign's first, it is placed where
/// half of them have passed; doubts say what they did.
void judge_trials(const PreparedCampaign& prepared, CampaignProposal& proposal);

}  // namespace clast::study_detail
