#pragma once
/// Team of processes that were started together by mpirun or srun, or a single process. Without MPI
/// support, there is always one process.
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace clast {

/// Team of processes that share the runs of one campaign. Rank 0 is the leader: it reads and writes
/// results, distributes runs and prints. The other processes compute.
///
/// There must be at most one object per program. It is not thread-safe.
class ProcessTeam {
 public:
  /// Joins the processes started together with this one.
  /// @throws InputError  if there are several processes, but clast was built without MPI
  ProcessTeam();
  /// Aborts the team if `begin` was called without `end`, because the others would wait forever.
  ~ProcessTeam();
  ProcessTeam(const ProcessTeam&) = delete;
  ProcessTeam& operator=(const ProcessTeam&) = delete;

  unsigned rank() const { return rank_; }
  unsigned size() const { return size_; }
  bool is_leader() const { return rank_ == 0; }

  /// Runs `prepare` in each process and checks that all return the same text.
  /// @throws Error  if `prepare` fails in any process, or if the texts differ
  void check_agreement(const std::function<std::string()>& prepare);

  /// Marks the start of a section during which the other processes depend on this one.
  void begin_dependent_section() { busy_ = true; }
  /// Marks the end of the section that `begin` starts.
  void end_dependent_section() { busy_ = false; }

  /// Sends the result of a finished item to the leader and receives the next item. The first call
  /// sends no result.
  /// @return empty if no item is left
  std::optional<std::size_t> exchange_item(const std::string& done);

  /// Result that a process sends to the leader.
  struct TeamMessage {
    unsigned from = 0;
    std::string done;
  };
  std::optional<TeamMessage> receive_message();
  /// Sends the next item to a process, or the message that no item is left. Only called by the
  /// leader.
  void send_item(unsigned to, std::optional<std::size_t> item);

 private:
  unsigned rank_ = 0;
  unsigned size_ = 1;
  bool busy_ = false;
};

}  // namespace clast
