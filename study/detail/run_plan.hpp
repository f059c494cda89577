#pragma once
/// Which runs a campaign makes, and where they start.
#include "study/campaign_runner.hpp"

namespace clast::study_detail {

/// Adds the runs to `prepared`, without their stiffness, and what the header says of them.
/// @param prepared  with campaign, blocks, terrain and header
/// @throws InputError       a point off the terrain; more runs than results can number
/// @throws SimulationError  a start inside the ground: run, block, point, orientation and depth
void plan_runs(PreparedCampaign& prepared);

}  // namespace clast::study_detail
