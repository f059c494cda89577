#pragma once
/// Paths of the results of a campaign.
#include <filesystem>
#include <optional>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Returns the path of the results of a shard, such as "results.2of4.h5" for shard 2 of 4 of
/// "results.h5".
std::filesystem::path shard_results_path(std::filesystem::path target,
                                         const std::optional<Shard>& shard);

/// Checks that there are no runs of an interrupted campaign for the results file `target`.
/// @throws InputError  if there are such runs, or if the campaign is still running
void check_not_interrupted(const std::filesystem::path& target);

}  // namespace clast
