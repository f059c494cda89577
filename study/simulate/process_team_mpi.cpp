#include <mpi.h>

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/error.hpp"
#include "core/files/digest.hpp"
#include "study/simulate/process_team.hpp"

namespace clast {
namespace {

constexpr int kDone = 1;  ///< tag of a finished item on its way to the leader
constexpr int kNext = 2;  ///< tag of the answer
constexpr std::int64_t kNothingLeft = -1;

// True if a launcher started this process as one of several. Checked before MPI starts, which takes
// a second and opens network ports that a single process does not need.
bool launched_together() {
  const auto several = [](const char* name) {
    const char* size = std::getenv(name);
    return size && std::atoi(size) > 1;
  };
  return several("OMPI_COMM_WORLD_SIZE") || several("PMI_SIZE") ||
         (std::getenv("PMIX_RANK") && several("SLURM_STEP_NUM_TASKS"));
}

// The text of process `from`, on all.
std::string shared_text(std::string text, int from) {
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, from, MPI_COMM_WORLD);
  text.resize(static_cast<std::size_t>(length));
  MPI_Bcast(text.data(), length, MPI_CHAR, from, MPI_COMM_WORLD);
  return text;
}

}  // namespace

ProcessTeam::ProcessTeam() {
  if (!launched_together()) return;
  int provided = 0, rank = 0, size = 1;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  if (provided < MPI_THREAD_SERIALIZED) {
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  rank_ = static_cast<unsigned>(rank);
  size_ = static_cast<unsigned>(size);
}

ProcessTeam::~ProcessTeam() {
  int started = 0;
  MPI_Initialized(&started);
  if (!started) return;
  if (busy_) MPI_Abort(MPI_COMM_WORLD, 1);
  MPI_Finalize();
}

void ProcessTeam::check_agreement(const std::function<std::string()>& prepare) {
  std::string failure, fingerprint;
  try {
    fingerprint = sha256(prepare());
  } catch (const std::exception& error) {
    if (size_ == 1) throw;
    failure = error.what();
  }
  if (size_ == 1) return;
  const int mine = failure.empty() ? static_cast<int>(size_) : static_cast<int>(rank_);
  int first = 0;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (first < static_cast<int>(size_)) {
    const std::string message = shared_text(failure, first);
    throw SimulationError(first == 0 ? message
                                     : "process " + std::to_string(first) + " failed: " + message);
  }
  const int same = shared_text(fingerprint, 0) == fingerprint ? 1 : 0;
  int all_same = 0;
  MPI_Allreduce(&same, &all_same, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (!all_same) {
    throw SimulationError(
        "the processes read different inputs or are different versions of clast; give all machines "
        "the same files and the same program");
  }
}

std::optional<std::size_t> ProcessTeam::exchange_item(const std::string& done) {
  MPI_Send(done.data(), static_cast<int>(done.size()), MPI_CHAR, 0, kDone, MPI_COMM_WORLD);
  std::int64_t item = kNothingLeft;
  MPI_Recv(&item, 1, MPI_INT64_T, 0, kNext, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  if (item == kNothingLeft) return std::nullopt;
  return static_cast<std::size_t>(item);
}

std::optional<ProcessTeam::TeamMessage> ProcessTeam::receive_message() {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, kDone, MPI_COMM_WORLD, &there, &status);
  if (!there) return std::nullopt;
  int length = 0;
  MPI_Get_count(&status, MPI_CHAR, &length);
  TeamMessage delivery{static_cast<unsigned>(status.MPI_SOURCE),
                       std::string(static_cast<std::size_t>(length), '\0')};
  MPI_Recv(delivery.done.data(), length, MPI_CHAR, status.MPI_SOURCE, kDone, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return delivery;
}

void ProcessTeam::send_item(unsigned to, std::optional<std::size_t> item) {
  const std::int64_t next = item ? static_cast<std::int64_t>(*item) : kNothingLeft;
  MPI_Send(&next, 1, MPI_INT64_T, static_cast<int>(to), kNext, MPI_COMM_WORLD);
}

}  // namespace clast
