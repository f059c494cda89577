#pragma once
/// The map of a campaign before it runs.
#include <string>

#include "study/results/results.hpp"

namespace clast {

/// An SVG file: relief and zones of the whole terrain, release points, barriers.
/// @param header  of a campaign without runs
std::string plan_map(const CampaignResults& header);

}  // namespace clast
