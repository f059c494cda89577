#include "core/files/detail/program_call.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <cstring>

#include "core/error.hpp"

namespace clast::files_detail {

namespace {
constexpr int kNotStarted = 127;
}

ProgramCall::ProgramCall(const std::vector<std::string>& command,
                         const std::vector<std::pair<std::string, std::string>>& environment)
    : words_(command) {
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    bool replaced = false;
    for (const auto& [name, value] : environment) replaced |= text.starts_with(name + "=");
    if (!replaced) variables_.push_back(text);
  }
  for (const auto& [name, value] : environment) variables_.push_back(name + "=" + value);
  for (std::string& word : words_) argv_.push_back(word.data());
  for (std::string& variable : variables_) envp_.push_back(variable.data());
  argv_.push_back(nullptr);
  envp_.push_back(nullptr);
}

/// The child's part after the fork: no function in it allocates, because another thread may hold
/// the heap's lock.
void ProgramCall::run(int out, int err, [[maybe_unused]] pid_t parent) const {
  ::setpgid(0, 0);
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kNotStarted);
#endif
  const int in = ::open("/dev/null", O_RDONLY);
  if (in < 0 || ::dup2(in, 0) < 0 || ::dup2(out, 1) < 0 || ::dup2(err, 2) < 0) {
    ::_exit(kNotStarted);
  }
  ::execve(argv_[0], argv_.data(), envp_.data());
  ::_exit(kNotStarted);
}

pid_t ProgramCall::start(int out, int err) const {
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) throw InputError(words_[0] + " can't be started: " + std::strerror(errno));
  if (child == 0) run(out, err, parent);
  ::setpgid(child, child);
  return child;
}

int exit_code_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int wait_for_exit(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return exit_code_of(status);
}

}  // namespace clast::files_detail
