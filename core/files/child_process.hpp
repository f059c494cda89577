#pragma once
/// Another program at work, with an end to the waiting.
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace clast {

struct ProcessResult {
  int exit_code = -1;      ///< 128 + signal when it was killed
  bool timed_out = false;  ///< it was ended because its time was over
};

/// Runs a program to its end. It reads nothing, writes both outputs to `log`, is ended with all it
/// started when its time is over, and when this program ends.
/// @param words        path of the program, and its arguments
/// @param environment  variables set for it beside the usual ones
/// @param seconds      time it has
/// @param waiting      called about twice a second while it runs
/// @throws InputError  it can't be started
ProcessResult run_child_process(const std::vector<std::string>& command,
                                const std::vector<std::pair<std::string, std::string>>& environment,
                                const std::filesystem::path& log, double time_limit,
                                const std::function<void()>& on_wait = {});

/// The file that a name stands for, by PATH; itself where it holds a slash. Empty: there is none
/// that may be run.
std::filesystem::path find_executable(const std::string& name);

}  // namespace clast
