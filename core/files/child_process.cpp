#include "core/files/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>

#include "core/error.hpp"

namespace clast {

namespace {

constexpr std::chrono::milliseconds kPoll{20};
constexpr int kPollsPerCall = 25;
constexpr int kNotStarted = 127;

/// Words and variables as `execve` takes them.
class ProgramCall {
 public:
  ProgramCall(const std::vector<std::string>& command,
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
  ProgramCall(const ProgramCall&) = delete;
  ProgramCall& operator=(const ProgramCall&) = delete;

  /// The child's part after the fork: no function in it allocates.
  [[noreturn]] void run(const char* log, [[maybe_unused]] pid_t parent) const {
    ::setpgid(0, 0);
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(kNotStarted);
#endif
    const int in = ::open("/dev/null", O_RDONLY);
    const int out = ::open(log, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (in < 0 || out < 0 || ::dup2(in, 0) < 0 || ::dup2(out, 1) < 0 || ::dup2(out, 2) < 0) {
      ::_exit(kNotStarted);
    }
    ::execve(argv_[0], argv_.data(), envp_.data());
    ::_exit(kNotStarted);
  }

 private:
  std::vector<std::string> words_, variables_;
  std::vector<char*> argv_, envp_;
};

}  // namespace

std::filesystem::path find_executable(const std::string& name) {
  const auto runs = [](const std::filesystem::path& file) {
    std::error_code code;
    return std::filesystem::is_regular_file(file, code) && ::access(file.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos)
    return runs(name) ? std::filesystem::path(name) : std::filesystem::path();
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path file = std::filesystem::path(folder.empty() ? "." : folder) / name;
    if (runs(file)) return file;
  }
  return {};
}

ProcessResult run_child_process(const std::vector<std::string>& command,
                                const std::vector<std::pair<std::string, std::string>>& environment,
                                const std::filesystem::path& log, double time_limit,
                                const std::function<void()>& on_wait) {
  // Everything that allocates comes before the fork: another thread may hold the heap's lock.
  const ProgramCall call(command, environment);
  const std::string log_name = log.string();
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) {
    throw InputError(command[0] + " can't be started: " + std::strerror(errno));
  }
  if (child == 0) call.run(log_name.c_str(), parent);
  ::setpgid(child, child);
  const auto start = std::chrono::steady_clock::now();
  ProcessResult end;
  int status = 0;
  for (int polls = 1;; ++polls) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR) throw InputError(command[0] + " was lost");
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    if (spent.count() > time_limit) {
      end.timed_out = true;
      ::kill(-child, SIGKILL);
      while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
      }
      break;
    }
    if (on_wait && polls % kPollsPerCall == 0) on_wait();
    std::this_thread::sleep_for(kPoll);
  }
  end.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return end;
}

}  // namespace clast
