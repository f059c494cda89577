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

/// Runs a program with no input and both outputs written to `log`. It and its children are killed
/// at the time limit and when this program ends.
/// @param command  path of the program and its arguments
/// @param environment  additional environment variables
/// @throws InputError  if it cannot be started
ProcessResult run_child_process(const std::vector<std::string>& command,
                                const std::vector<std::pair<std::string, std::string>>& environment,
                                const std::filesystem::path& log, double time_limit,
                                const std::function<void()>& on_wait = {});

/// Finds an executable on PATH; returns the name itself if it contains a slash, and an empty path
/// if nothing is found.
std::filesystem::path find_executable(const std::string& name);

}  // namespace clast
