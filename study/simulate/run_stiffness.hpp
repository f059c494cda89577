#pragma once
/// Stiffness and time step of all planned runs.
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Chooses contact stiffness and time step of each planned run, from its block, its ground
/// parameters and the largest speed that its start allows. Runs of a realisation share one choice.
/// @return warnings, ordered by block; for persistent blocks, those of the first realisation that
/// has warnings
/// @throws SimulationError  if the given time step is too long for a block; names the block
/// @throws InputError  if settings are impossible; names field and value
std::vector<std::string> choose_run_stiffness(CampaignPlan& prepared);

}  // namespace clast::study_detail
