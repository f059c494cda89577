#pragma once
/// Distribution of work items over a team of processes.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "study/simulate/process_team.hpp"

namespace clast {

/// Distributes work items to the processes of a team and computes some of them on the leader.
/// Returns when all items are finished. An exception of `here` or `accept` ends the work after the
/// current items.
/// @param threads  number of threads per process, equal in all processes
/// @param here  function that computes and stores an item; called from several threads
/// @param accept  function that stores an item computed by another process; may be called at the
///                same time as `here`
void distribute_work(ProcessTeam& team, const std::vector<std::uint32_t>& items, unsigned threads,
                     const std::function<void(std::uint32_t item)>& here,
                     const std::function<void(const std::string& done)>& accept);

/// Computes the items received from the leader until none is left.
/// @param compute  returns the bytes for `accept`, not empty; called from several threads
void process_received_work(ProcessTeam& team, unsigned threads,
                           const std::function<std::string(std::uint32_t item)>& compute);

}  // namespace clast
