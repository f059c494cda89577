#pragma once
/// What is wrong or doubtful about a campaign whose runs are planned.
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// "release set cliff, " where there are several, else "".
std::string format_release_set_name(const ReleaseSet& release);

/// Refuses releases from heights no slope has.
/// @throws InputError  a fall to the lowest ground could end faster than `kMostSpeed`
void check_falls(const CampaignPlan& prepared);

/// What is unusual about a block of this length (m) and mass (kg) on a terrain of this extent (m):
/// its size, and what is usual; empty: nothing.
std::string describe_unusual_size(const std::string& block, double length, double mass, double extent);

/// @throws InputError  a block longer than 20 m, heavier than 10,000 t, or longer than a tenth of
///                     the terrain, unless the campaign allows any size
void check_sizes(const CampaignPlan& prepared);

/// What its user should know before anything runs: doubtful inputs in words, none where all is
/// usual. Stiffness and time step must have been chosen; doubts about these are not reported here.
/// @throws InputError  a run would take so many steps that it never ends
std::vector<std::string> check_campaign_settings(const CampaignPlan& prepared);

}  // namespace clast::study_detail
