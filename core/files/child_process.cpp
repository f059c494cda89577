#include "core/files/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>

#include "core/error.hpp"
#include "core/files/detail/program_call.hpp"

namespace clast {

namespace {

constexpr std::chrono::milliseconds kPoll{20};
constexpr int kPollsPerCall = 25;

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
  const files_detail::ProgramCall call(command, environment);
  const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (out < 0) throw InputError(log.string() + ": can't be written: " + std::strerror(errno));
  pid_t child = -1;
  try {
    child = call.start(out, out);
  } catch (...) {
    ::close(out);
    throw;
  }
  ::close(out);
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
      end.exit_code = files_detail::wait_for_exit(child);
      return end;
    }
    if (on_wait && polls % kPollsPerCall == 0) on_wait();
    std::this_thread::sleep_for(kPoll);
  }
  end.exit_code = files_detail::exit_code_of(status);
  return end;
}

}  // namespace clast
