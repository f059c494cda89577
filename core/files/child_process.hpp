#pragma once
/// Child processes with a time limit.
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace clast {

struct ProcessResult {
  int exit_code = -1;      ///< 128 + signal if the process was killed
  bool timed_out = false;  ///< true if the time limit was exceeded
};

/// Runs a program without input and writes its outputs (stdout and stderr) to `log`. The program
/// and its children are killed at the time limit, and when this program ends.
/// @param command  path of the program and its arguments
/// @param environment  additional environment variables
/// @throws InputError  if the program cannot be started
ProcessResult run_child_process(const std::vector<std::string>& command,
                                const std::vector<std::pair<std::string, std::string>>& environment,
                                const std::filesystem::path& log, double time_limit,
                                const std::function<void()>& on_wait = {});

/// Finds an executable on PATH. A name with a slash is returned unchanged. Returns an empty path if
/// there is none.
std::filesystem::path find_executable(const std::string& name);

}  // namespace clast
