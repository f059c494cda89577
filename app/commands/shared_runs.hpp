#pragma once
/// Shards and process teams of commands.
#include <functional>
#include <optional>
#include <string>

#include "study/simulate/campaign_runner.hpp"

namespace clast {

/// Parses a shard such as "2/4". Empty if the text is empty.
/// @throws CLI::ValidationError  if the text is invalid
std::optional<Shard> parse_shard(const std::string& text);

/// Runs a command in each process of the team. Only the leader prints. Errors of the other
/// processes are passed to it.
void run_in_team(const std::function<void(ProcessTeam& team)>& command);

}  // namespace clast
