#pragma once
/// Companion executables with the commands whose libraries load slowly.
#include <CLI/CLI.hpp>
#include <functional>
#include <string_view>

#include "app/command_tree.hpp"

namespace clast {

/// Command that only a companion executable has.
struct CompanionCommand {
  const char* name;
  const char* summary;  ///< first line of its help, shown by both executables
  const char* program;  ///< name of the executable
};

/// Returns the command of that name; null if the program itself has it, or none has.
const CompanionCommand* find_companion_command(std::string_view name);

/// Adds a command of a companion executable, which runs when the command line is parsed.
CLI::App& add_companion_command(CLI::App& app, std::string_view name);

/// Replaces this process by the companion executable. Only `clast-simulate` links GDAL and MPI, and
/// only `clast-reconstruct` PCL and OpenCV. Both are beside the program, or in the folder for
/// internal executables.
/// @throws InputError  if the executable is not installed
[[noreturn]] void run_companion(const CompanionCommand& command, char** argv);

/// Returns the options of a companion's command, as the executable describes them.
/// @throws InputError  if the executable is not installed or fails
CommandEntry read_companion_options(const CompanionCommand& command);

/// Main function of a companion executable. Besides its commands it has `help` for them.
int run_companion_program(int argc, char** argv,
                          const std::function<void(CLI::App&)>& add_commands);

}  // namespace clast
