#pragma once
/// Tree of commands and options as plain values, from which shell completion is generated.
#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace clast {

/// Option, flag or positional argument.
struct OptionEntry {
  std::vector<std::string> names;  ///< "-o", "--output"; for a positional argument its name
  bool positional = false;
  bool repeated = false;             ///< accepts any number of values
  std::string value;                 ///< placeholder in the help text, "FILE"; empty for flags
  std::vector<std::string> choices;  ///< allowed values; empty: any
  std::string description;
};

struct CommandEntry {
  std::string name;  ///< last word
  std::string summary;
  std::vector<OptionEntry> options;
  std::vector<CommandEntry> commands;
};

/// Builds the tree of a command-line parser.
CommandEntry build_command_tree(const CLI::App& command);

nlohmann::json to_json(const CommandEntry& command);
/// Reads the JSON of `to_json`.
/// @throws nlohmann::json::exception  if it was not written by `to_json`
CommandEntry command_from_json(const nlohmann::json& json);

}  // namespace clast
