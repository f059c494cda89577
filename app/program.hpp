#pragma once
/// What the program and its companion share: parsing, exit codes, messages.
#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace clast {

/// Adds the commands, parses the command line, which runs the one that was named, and gives the
/// exit code: 0 done, 1 failed, 2 misused.
int run_program(int argc, char** argv, const std::function<void(CLI::App&)>& add_commands);

/// All words of a command, "clast new campaign".
std::string full_command_name(const CLI::App& command);

}  // namespace clast
