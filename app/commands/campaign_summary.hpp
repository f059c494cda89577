#pragma once
/// Output of `clast simulate` on a campaign and its results.
#include "study/results/results.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Prints the plan of a campaign to stdout: runs, blocks, release points and warnings.
void print_plan(const CampaignPlan& prepared);

/// Prints contact stiffness and time step of each block to stdout.
void print_stiffness(const CampaignPlan& prepared);

/// Prints the outcome of a campaign to stdout: stop reasons, barrier crossings and energy errors.
void print_outcome(const CampaignResults& results);

}  // namespace clast
