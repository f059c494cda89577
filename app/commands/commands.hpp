#pragma once
/// Commands of the program, one file each. Each function adds a subcommand that runs when the
/// command line is parsed.
///
/// Commands throw clast::Error on failure (exit code 1), CLI::ValidationError on misuse (2).
#include <CLI/CLI.hpp>

namespace clast {

void add_reconstruct_command(CLI::App& app);
void add_cut_command(CLI::App& app);
void add_vary_command(CLI::App& app);
void add_show_command(CLI::App& app);
void add_classify_command(CLI::App& app);
void add_export_command(CLI::App& app);
void add_library_command(CLI::App& app);
void add_terrain_command(CLI::App& app);
void add_new_command(CLI::App& app);
void add_check_command(CLI::App& app);
void add_simulate_command(CLI::App& app);
void add_compare_command(CLI::App& app);
void add_import_command(CLI::App& app);
void add_calibrate_command(CLI::App& app);

/// Adds the command `help`, which also explains the commands of companion executables.
/// @param app  must outlive the parsing
/// @param argv  arguments of the program, for the companion executable
void add_help_command(CLI::App& app, char** argv);

}  // namespace clast
