#pragma once
/// Main function of the program and of its companion executable: parsing, exit codes, messages.
#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace clast {

/// Runs the command that the command line names. Returns the exit code: 0 for success, 1 for
/// failure, 2 for misuse.
int run_program(int argc, char** argv, const std::function<void(CLI::App&)>& add_commands);

/// Prints the help of a command to stdout.
/// @param words  the command and its subcommands; empty for the help of the program
/// @throws CLI::ValidationError  if there is no such command
void print_command_help(const CLI::App& app, const std::vector<std::string>& words);

/// Returns all words of a command, such as "clast new campaign".
std::string full_command_name(const CLI::App& command);

}  // namespace clast
