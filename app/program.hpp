#pragma once
/// Main function of the program and of its companion executable: parsing, exit codes, messages.
#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace clast {

/// Runs the command that the command line names. Returns the exit code: 0 for success, 1 for
/// failure, 2 for misuse.
int run_program(int argc, char** argv, const std::function<void(CLI::App&)>& add_commands);

/// Returns all words of a command, such as "clast new campaign".
std::string full_command_name(const CLI::App& command);

}  // namespace clast
