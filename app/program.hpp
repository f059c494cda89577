#pragma once
/// What the program and its companion share: parsing, exit codes, messages.
#include <CLI/CLI.hpp>
#include <functional>

namespace clast {

/// Adds the commands, parses the command line, which runs the one that was named, and gives the
/// exit code: 0 done, 1 failed, 2 misused.
int run_program(int argc, char** argv, const std::function<void(CLI::App&)>& add_commands);

}  // namespace clast
