#pragma once
/// The commands of the program, one file each. Every function adds its subcommand; parsing the
/// command line then runs the one that was named.
///
/// Commands throw clast::Error when something failed (exit code 1) and CLI::ValidationError when an
/// option's value makes no sense (exit code 2).
#include <CLI/CLI.hpp>
#include <functional>

#include "app/command_tree.hpp"

namespace clast {

void add_reconstruct(CLI::App& app);
void add_cut(CLI::App& app);
void add_vary(CLI::App& app);
void add_show(CLI::App& app);
void add_classify(CLI::App& app);
void add_export(CLI::App& app);
void add_library(CLI::App& app);
void add_terrain(CLI::App& app);
void add_new(CLI::App& app);
void add_check(CLI::App& app);
void add_simulate(CLI::App& app);
void add_compare(CLI::App& app);
void add_import(CLI::App& app);
void add_calibrate(CLI::App& app);

/// Where `help` finds what the program itself does not know of a command.
struct ReconstructHelp {
  std::function<void()> show;             ///< its help, on stdout
  std::function<CommandEntry()> options;  ///< its tables
};
/// @param app  must outlive the parsing
void add_help(CLI::App& app, const ReconstructHelp& reconstruct);

}  // namespace clast
