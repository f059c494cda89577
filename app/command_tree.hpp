#pragma once
/// Tree of commands and options, from which help and shell completion are generated.
#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace clast {

/// Option, flag or positional argument.
struct OptionEntry {
  /// Names, such as "-o" and "--output", or the name of a positional argument.
  std::vector<std::string> names;
  bool positional = false;
  bool repeated = false;  ///< true if any number of values is accepted
  /// Placeholder of the value in the help text, such as "FILE"; empty for flags.
  std::string value;
  std::vector<std::string> choices;  ///< allowed values; if empty, any value is allowed
  std::string description;
};

struct CommandEntry {
  std::string name;  ///< last word of the command
  std::string summary;
  std::vector<OptionEntry> options;
  std::vector<CommandEntry> commands;
};

/// Builds the tree of the commands of a command-line parser.
CommandEntry build_command_tree(const CLI::App& command);

nlohmann::json to_json(const CommandEntry& command);
/// Parses a command from the JSON that `to_json` returns.
/// @throws nlohmann::json::exception  if it was not written by `to_json`
CommandEntry parse_command_entry(const nlohmann::json& json);

}  // namespace clast
