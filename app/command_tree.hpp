#pragma once
/// Commands with their options as plain values, from the tables that parse the command line: what
/// shell completion is made of.
#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace clast {

/// An option, a flag or a positional argument.
struct OptionEntry {
  std::vector<std::string> names;  ///< "-o", "--output"; of an argument its name alone
  bool positional = false;
  bool repeated = false;             ///< takes any number of values
  std::string value;                 ///< what stands for its value in help, "FILE"; of a flag empty
  std::vector<std::string> choices;  ///< the only values there are; empty: any
  std::string description;
};

/// A command and those below it.
struct CommandEntry {
  std::string name;  ///< its last word
  std::string summary;
  std::vector<OptionEntry> options;
  std::vector<CommandEntry> commands;
};

CommandEntry build_command_tree(const CLI::App& command);

nlohmann::json to_json(const CommandEntry& command);
/// @throws nlohmann::json::exception  not written by `to_json`
CommandEntry command_from_json(const nlohmann::json& json);

}  // namespace clast
