#pragma once
/// Checks of a planned campaign.
#include <string>
#include <vector>

#include "study/simulate/campaign_runner.hpp"

namespace clast::study_detail {

/// Formats the name of a release set for messages, such as "release set cliff, ". Empty if it has
/// no name.
std::string format_release_set_name(const ReleaseSet& release);

/// Checks the heights from which blocks fall.
/// @throws InputError  if the speed of a fall to the lowest ground could exceed `kMaxInitialSpeed`
void check_fall_speeds(const CampaignPlan& prepared);

/// Describes an unusual size of a block, and the usual range. Empty if the size is usual.
/// @param length  length of the block, m
/// @param mass  mass of the block, kg
/// @param extent  extent of the terrain, m
std::string describe_unusual_size(const std::string& block, double length, double mass,
                                  double extent);

/// Checks the sizes of the blocks, unless the campaign allows any size.
/// @throws InputError  if a block is longer than 20 m, heavier than 10,000 t, or longer than a
///                     tenth of the terrain
void check_block_sizes(const CampaignPlan& prepared);

/// Checks the settings of a campaign and returns warnings. `choose_run_stiffness` must be called
/// before.
/// @throws InputError  if a run would need too many time steps
std::vector<std::string> check_campaign_settings(const CampaignPlan& prepared);

}  // namespace clast::study_detail
