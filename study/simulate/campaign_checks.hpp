#pragma once
/// Errors and warnings of a planned campaign.
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Returns "release set cliff, ", or "" if there is only one set.
std::string format_release_set_name(const ReleaseSet& release);

/// Checks the release heights.
/// @throws InputError  if a fall to the lowest ground could exceed `kMaxSpeed`
void check_falls(const CampaignPlan& prepared);

/// Describes an unusual size of a block of given length (m) and mass (kg) on a terrain of given
/// extent (m), and the usual range; empty if the size is usual.
std::string describe_unusual_size(const std::string& block, double length, double mass,
                                  double extent);

/// Checks the block sizes, unless the campaign allows any size.
/// @throws InputError  if a block is longer than 20 m, heavier than 10,000 t, or longer than a
///                     tenth of the terrain
void check_sizes(const CampaignPlan& prepared);

/// Returns warnings about doubtful inputs; empty if there are none. Stiffness and time step must
/// have been chosen; `choose_run_stiffness` warns about these.
/// @throws InputError  if a run would take too many steps to end
std::vector<std::string> check_campaign_settings(const CampaignPlan& prepared);

}  // namespace clast::study_detail
