#pragma once
/// Output of `clast simulate` on a campaign and its results.
#include "study/results/results.hpp"
#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Prints runs, blocks, release points and warnings to stdout.
void print_plan(const CampaignPlan& prepared);

/// Prints stiffness and time step by block to stdout.
void print_stiffness(const CampaignPlan& prepared);

/// Prints stop reasons, runs below ground, barrier crossings and largest energy errors to stdout.
void print_outcome(const CampaignResults& results);

}  // namespace clast
