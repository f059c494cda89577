#pragma once
/// What `clast simulate` says about a campaign before its runs, and about their results.
#include "study/campaign_runner.hpp"
#include "study/results.hpp"

namespace clast {

/// Runs, blocks, release points, stiffness by block and warnings, on stdout.
void print_plan(const PreparedCampaign& prepared);

/// Stop reasons, runs below ground, barrier crossings, largest errors of energy, on stdout.
void print_outcome(const CampaignResults& results);

}  // namespace clast
