#pragma once
/// Ground parameters of a campaign, drawn for each ensemble member, in the order of the zones.
#include <string>
#include <vector>

#include "study/campaign/campaign.hpp"
#include "study/results/results.hpp"

namespace clast::study_detail {

/// Draws the ground parameters of each block group in each ensemble member. Sets are ordered by
/// group, blocks in no group first, then by member.
/// @param zones  names of the zones, in the order of the terrain
/// @throws InputError  if a zone has no parameters, or parameters have no zone
std::vector<GroundParameterSet> sample_ground_sets(const Campaign& campaign,
                                                   const std::vector<std::string>& zones);

/// Returns the ground parameters of blocks in no group, with the central values of uncertain
/// parameters.
std::vector<GroundParameters> compute_median_ground(const Campaign& campaign,
                                                    const std::vector<std::string>& zones);

}  // namespace clast::study_detail
