#pragma once
/// The ground parameters of a campaign, drawn and put in the order of the terrain's zones.
#include <string>
#include <vector>

#include "study/campaign/campaign.hpp"
#include "study/results/results.hpp"

namespace clast::study_detail {

/// One set for each block group (blocks in no group first) and member of the ensemble (fastest).
/// A parameter that a group does not name is the same for all groups of a member.
/// @param zones  names, in the terrain's order
/// @throws InputError  a zone without parameters, or parameters of no zone
std::vector<GroundParameterSet> draw_ground_sets(const Campaign& campaign, const std::vector<std::string>& zones);

/// The parameters of blocks in no group, uncertain ones at their middle, mean or median.
std::vector<GroundParameters> median_ground(const Campaign& campaign,
                                             const std::vector<std::string>& zones);

}  // namespace clast::study_detail
