#pragma once
/// Distribution of work items over a team of processes.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "study/simulate/process_team.hpp"

namespace clast {

/// Distributes items and computes some of them on the leader. Returns when all are done; exceptions
/// of `here` or `accept` end the work after the current items and are rethrown once all processes
/// know of them.
/// @param threads  per process, equal on all
/// @param here  computes and stores an item; called from several threads
/// @param accept  stores an item computed by another process; called beside `here`
void distribute_work(ProcessTeam& team, const std::vector<std::uint32_t>& items, unsigned threads,
                     const std::function<void(std::uint32_t item)>& here,
                     const std::function<void(const std::string& done)>& accept);

/// Computes the items received from the leader until none is left.
/// @param compute  returns the bytes for `accept`, not empty; called from several threads
void process_received_work(ProcessTeam& team, unsigned threads,
                           const std::function<std::string(std::uint32_t item)>& compute);

}  // namespace clast
