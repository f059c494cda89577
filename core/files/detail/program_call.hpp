#pragma once
/// Starting of child processes.
#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace clast::files_detail {

/// Program, arguments and environment variables as `execve` takes them.
class ProgramCall {
 public:
  /// @param command  path of the program and its arguments
  /// @param environment  additional environment variables
  ProgramCall(const std::vector<std::string>& command,
              const std::vector<std::pair<std::string, std::string>>& environment);
  ProgramCall(const ProgramCall&) = delete;
  ProgramCall& operator=(const ProgramCall&) = delete;

  /// Starts the program without input, as leader of a process group. It is killed when this program
  /// ends.
  /// @param out  descriptor of its standard output
  /// @param err  descriptor of its standard error
  /// @return  its process id
  /// @throws InputError  if no process can be created
  pid_t start(int out, int err) const;

 private:
  [[noreturn]] void run(int out, int err, pid_t parent) const;

  std::vector<std::string> words_, variables_;
  std::vector<char*> argv_, envp_;
};

/// Waits for the end of a child process.
/// @return  its exit code, 128 + signal if it was killed
int wait_for_exit(pid_t child);

/// Returns the exit code in a status of `waitpid`, 128 + signal if the process was killed.
int exit_code_of(int status);

}  // namespace clast::files_detail
