#pragma once
/// Commands whose runs are shared by shards and by processes.
#include <functional>
#include <optional>
#include <string>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// "2/4"; none of an empty text.
/// @throws CLI::ValidationError  anything else
std::optional<Shard> parse_shard(const std::string& text);

/// Runs a command in every process that was started with this one. Only the one that leads prints,
/// and only its errors are shown: those of the others reach it.
void run_in_team(const std::function<void(ProcessTeam& team)>& command);

}  // namespace clast
