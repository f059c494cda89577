#pragma once
/// The processes that mpirun or srun started together, or one process alone. MPI stays inside the
/// .cpp; a clast that was configured without MPI is always alone.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace clast {

/// Processes that share the runs of one campaign. Number 0 leads: it reads and writes the results,
/// hands out runs, and speaks to the user; the others compute.
///
/// One per program. Calls of one process must not overlap in time.
class ProcessTeam {
 public:
  /// Joins the processes started with this one, if there are any.
  /// @throws InputError  started as one of several, but built without MPI: each would run it all
  ProcessTeam();
  /// Ends the whole team when it is left by an exception between `begin` and `end`, since the
  /// others would wait for ever.
  ~ProcessTeam();
  ProcessTeam(const ProcessTeam&) = delete;
  ProcessTeam& operator=(const ProcessTeam&) = delete;

  unsigned rank() const { return rank_; }
  unsigned size() const { return size_; }
  bool is_leader() const { return rank_ == 0; }

  /// Runs `prepare` on every process, then makes sure that all succeeded and that all came to the
  /// same `fingerprint`, which `prepare` returns.
  /// @throws Error of this process, else SimulationError with the message of the first that failed,
  /// or because inputs differ between processes
  void agree(const std::function<std::string()>& prepare);

  /// The others depend on this process from here ...
  void begin() { busy_ = true; }
  /// ... to here.
  void end() { busy_ = false; }

  /// Gives the leader `done`, the bytes of a finished item (empty at first), and gets the next
  /// item.
  /// @return none when there is nothing left to do
  std::optional<std::size_t> exchange(const std::string& done);

  /// On the leader: what a process handed in, if one did.
  struct TeamMessage {
    unsigned from = 0;
    std::string done;
  };
  std::optional<TeamMessage> delivery();
  /// On the leader: answers a delivery with the next item, or that there is none.
  void answer(unsigned to, std::optional<std::size_t> item);

 private:
  unsigned rank_ = 0;
  unsigned size_ = 1;
  bool busy_ = false;
};

}  // namespace clast
