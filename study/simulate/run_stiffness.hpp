#pragma once
/// Stiffness and time step of every planned run.
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Chooses them for each run from its own data: its block, the ground set that it meets, and
/// the fastest speed that its own start allows. No other block, release or member of the ensemble
/// changes what a run gets. Only where blocks stay do those of a realisation share one choice.
/// @return what the user should know, by block; where blocks stay, of the first realisation that
///         there is something to know of
/// @throws SimulationError  a time step of the user's that is too long for a block: its name
/// @throws InputError       settings that no run can have: field and value
std::vector<std::string> choose_run_stiffness(CampaignPlan& prepared);

}  // namespace clast::study_detail
