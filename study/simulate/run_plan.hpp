#pragma once
/// Planning of the runs of a campaign and their starts.
#include <cstdint>
#include <span>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Plans all runs (without stiffness) and completes the header.
/// @param prepared  with campaign, blocks, terrain and header
/// @throws InputError  if a point is outside the terrain, or there are more runs than results can
///                     number
/// @throws SimulationError  if a start is inside the ground; names run, block, point, orientation
///                          and depth
void plan_runs(CampaignPlan& prepared);

/// Plans only the runs with the given indices, by the campaign's present settings.
/// @param prepared  planned, without persistent blocks; blocks and starts may have changed since,
///                  but not their numbers
/// @throws SimulationError  if a start is inside the ground
std::vector<RunRecord> make_planned_runs(CampaignPlan& prepared,
                                         std::span<const std::uint32_t> numbers);

}  // namespace clast::study_detail
