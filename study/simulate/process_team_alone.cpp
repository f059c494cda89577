// A team of one, for a clast without MPI.
#include <cstdlib>
#include <string>

#include "core/error.hpp"
#include "study/simulate/process_team.hpp"

namespace clast {

ProcessTeam::ProcessTeam() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* size = std::getenv(name);
    if (size && std::string(size) != "1") {
      throw InputError("started as one of " + std::string(size) +
                       " processes, but this clast was built without MPI, so each would run the "
                       "whole campaign; install MPI and configure again, or use `shard`");
    }
  }
}
ProcessTeam::~ProcessTeam() = default;

void ProcessTeam::check_agreement(const std::function<std::string()>& prepare) { prepare(); }
std::optional<std::size_t> ProcessTeam::exchange_item(const std::string&) { return std::nullopt; }
std::optional<ProcessTeam::TeamMessage> ProcessTeam::receive_message() { return std::nullopt; }
void ProcessTeam::send_item(unsigned, std::optional<std::size_t>) {}

}  // namespace clast
