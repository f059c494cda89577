#pragma once
/// Ground parameters of a campaign, drawn and ordered by terrain zones.
#include <string>
#include <vector>

#include "study/campaign/campaign.hpp"
#include "study/results/results.hpp"

namespace clast::study_detail {

/// Draws one set per block group (blocks in no group first) and ensemble member (fastest).
/// Parameters that a group does not state are equal for all groups of a member.
/// @param zones  names, in the terrain's order
/// @throws InputError  if a zone has no parameters, or parameters have no zone
std::vector<GroundParameterSet> sample_ground_sets(const Campaign& campaign,
                                                   const std::vector<std::string>& zones);

/// Returns the parameters of blocks in no group; uncertain ones at their midpoint, mean or median.
std::vector<GroundParameters> compute_median_ground(const Campaign& campaign,
                                                    const std::vector<std::string>& zones);

}  // namespace clast::study_detail
