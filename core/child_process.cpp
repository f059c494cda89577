#include "core/child_process.hpp"

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

}  // namespace

std::filesystem::path program_named(const std::string& name) {
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

ChildEnd run_child(const std::vector<std::string>& words,
                   const std::vector<std::pair<std::string, std::string>>& environment,
                   const std::filesystem::path& log, double seconds,
                   const std::function<void()>& waiting) {
  // Everything that allocates comes before the fork: another thread may hold the heap's lock.
  std::vector<std::string> own = words;
  std::vector<char*> argv;
  for (std::string& word : own) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::vector<std::string> variables;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    bool replaced = false;
    for (const auto& [name, value] : environment) replaced |= text.starts_with(name + "=");
    if (!replaced) variables.push_back(text);
  }
  for (const auto& [name, value] : environment) variables.push_back(name + "=" + value);
  std::vector<char*> envp;
  for (std::string& variable : variables) envp.push_back(variable.data());
  envp.push_back(nullptr);
  const std::string log_name = log.string();

  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) {
    throw InputError(words[0] + " can't be started: " + std::strerror(errno));
  }
  if (child == 0) {
    ::setpgid(0, 0);
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(kNotStarted);
#endif
    const int in = ::open("/dev/null", O_RDONLY);
    const int out = ::open(log_name.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (in < 0 || out < 0 || ::dup2(in, 0) < 0 || ::dup2(out, 1) < 0 || ::dup2(out, 2) < 0) {
      ::_exit(kNotStarted);
    }
    ::execve(argv[0], argv.data(), envp.data());
    ::_exit(kNotStarted);
  }
  (void)parent;
  ::setpgid(child, child);
  const auto start = std::chrono::steady_clock::now();
  ChildEnd end;
  int status = 0;
  for (int polls = 1;; ++polls) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR) throw InputError(words[0] + " was lost");
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    if (spent.count() > seconds) {
      end.timed_out = true;
      ::kill(-child, SIGKILL);
      while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
      }
      break;
    }
    if (waiting && polls % kPollsPerCall == 0) waiting();
    std::this_thread::sleep_for(kPoll);
  }
  end.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return end;
}

}  // namespace clast
