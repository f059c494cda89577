#pragma once
/// Main function shared by the program and its companion: parsing, exit codes, messages.
#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace clast {

/// Adds the commands, parses the command line, which runs the chosen command, and returns the exit
/// code: 0 done, 1 failed, 2 misuse.
int run_program(int argc, char** argv, const std::function<void(CLI::App&)>& add_commands);

/// Returns all words of a command: "clast new campaign".
std::string full_command_name(const CLI::App& command);

}  // namespace clast
