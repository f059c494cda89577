#pragma once
/// Items that the processes of a team compute together.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "study/simulate/process_team.hpp"

namespace clast {

/// On the process that leads: hands out the items, and computes beside the others. Returns when all
/// items are done; what `here` or `accept` throws ends the work after the items under way, and is
/// thrown once every process knows of it.
/// @param threads  of each process, the same on all
/// @param here     computes an item and keeps it; from several threads at once
/// @param accept   keeps what another process computed; beside `here`
void lead_work(ProcessTeam& team, const std::vector<std::uint32_t>& items, unsigned threads,
               const std::function<void(std::uint32_t item)>& here,
               const std::function<void(const std::string& done)>& accept);

/// On the others: computes items as they are handed out, until there are none.
/// @param compute  returns what `accept` gets, never empty; from several threads at once
void follow_work(ProcessTeam& team, unsigned threads,
                 const std::function<std::string(std::uint32_t item)>& compute);

}  // namespace clast
