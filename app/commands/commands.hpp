#pragma once
/// Commands of the program, one file each. Each function adds a subcommand that runs when the
/// command line is parsed.
///
/// Commands throw clast::Error on failure (exit code 1), CLI::ValidationError on misuse (2).
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

/// Functions that give the help of `reconstruct`, which is a separate executable.
struct ReconstructHelp {
  std::function<void()> show;             ///< prints its help to stdout
  std::function<CommandEntry()> options;  ///< returns its options
};
/// Adds the command `help`.
/// @param app  must outlive the parsing
void add_help(CLI::App& app, const ReconstructHelp& reconstruct);

}  // namespace clast
