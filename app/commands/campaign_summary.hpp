#pragma once
/// What `clast simulate` says about a campaign before its runs, and about their results.
#include "study/results/results.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Runs, blocks, release points and warnings, on stdout.
void print_plan(const CampaignPlan& prepared);

/// Stiffness and time step by block, on stdout: what the numbers above rest on.
void print_stiffness(const CampaignPlan& prepared);

/// Stop reasons, runs below ground, barrier crossings, largest errors of energy, on stdout.
void print_outcome(const CampaignResults& results);

}  // namespace clast
