#pragma once
/// Which runs a campaign makes, and where they start.
#include <cstdint>
#include <span>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Adds the runs to `prepared`, without their stiffness, and what the header says of them.
/// @param prepared  with campaign, blocks, terrain and header
/// @throws InputError       a point off the terrain; more runs than results can number
/// @throws SimulationError  a start inside the ground: run, block, point, orientation and depth
void plan_runs(CampaignPlan& prepared);

/// The runs of these numbers, out of all that `plan_runs` would plan, as the campaign is now.
/// @param prepared  planned, without blocks that stay; its blocks and starts may have changed since
/// then, but not how many there are
/// @throws SimulationError  a start inside the ground
std::vector<RunRecord> make_planned_runs(CampaignPlan& prepared, std::span<const std::uint32_t> numbers);

}  // namespace clast::study_detail
