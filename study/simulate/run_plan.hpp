#pragma once
/// Planning of the runs of a campaign and their starts.
#include <cstdint>
#include <span>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Plans all runs of a campaign and their starts, and completes its header. The stiffness of the
/// runs is not set.
/// @param prepared  plan with campaign, blocks, terrain and header
/// @throws InputError  if a point is outside the terrain, or there are more than 99,999,999 runs
/// @throws SimulationError  if a start is inside the ground; names run, block, point, orientation
///                          and depth
void plan_runs(CampaignPlan& prepared);

/// Plans the given runs again, after blocks or starts of the campaign have changed.
/// @param prepared  planned campaign in which each run simulates one block; the number of blocks
///                  and the number of starts must be unchanged
/// @throws SimulationError  if a start is inside the ground
std::vector<RunRecord> plan_selected_runs(CampaignPlan& prepared,
                                          std::span<const std::uint32_t> numbers);

}  // namespace clast::study_detail
