#pragma once
/// Where the results of a campaign go.
#include <filesystem>
#include <optional>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// "results.h5" of shard 2 of 4 is "results.2of4.h5", so that shards started with one name do not
/// write over each other; without a shard it is "results.h5".
std::filesystem::path shard_file(std::filesystem::path target, const std::optional<Shard>& shard);

/// Refuses a place where an interrupted campaign left runs that would be lost.
/// @throws InputError  it left some, or is still running
void refuse_interrupted(const std::filesystem::path& target);

}  // namespace clast
