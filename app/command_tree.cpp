#include "app/command_tree.hpp"

#include <nlohmann/json.hpp>

namespace clast {

namespace {

/// Returns the choices that validators append to the type of an option: "{auto,y,z}".
std::vector<std::string> choices_in(const std::string& type) {
  std::vector<std::string> choices;
  const std::size_t open = type.find('{'), close = type.rfind('}');
  if (open == type.npos || close == type.npos || close < open) return choices;
  std::string word;
  for (const char character : type.substr(open + 1, close - open - 1)) {
    if (character == ',') {
      choices.push_back(word);
      word.clear();
    } else {
      word += character;
    }
  }
  choices.push_back(word);
  return choices;
}

OptionEntry entry_of(const CLI::Option& option) {
  OptionEntry entry;
  entry.positional = !option.nonpositional();
  if (entry.positional) {
    entry.names.push_back(option.get_name(true, false));
  } else {
    for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  }
  entry.repeated = option.get_items_expected_max() >= CLI::detail::expected_max_vector_size;
  entry.description = option.get_description();
  if (option.get_items_expected_max() == 0) return entry;  // a flag
  const std::string type = option.get_type_name();
  entry.value = type.substr(0, type.find(':'));
  if (entry.value.empty()) entry.value = "VALUE";
  entry.choices = choices_in(type);
  return entry;
}

}  // namespace

CommandEntry build_command_tree(const CLI::App& command) {
  CommandEntry entry{command.get_name(), command.get_description(), {}, {}};
  for (const CLI::Option* option : command.get_options())
    entry.options.push_back(entry_of(*option));
  for (const CLI::App* part : command.get_subcommands({})) {
    if (!part->get_group().empty()) entry.commands.push_back(build_command_tree(*part));
  }
  return entry;
}

nlohmann::json to_json(const CommandEntry& command) {
  nlohmann::json options = nlohmann::json::array(), commands = nlohmann::json::array();
  for (const OptionEntry& option : command.options) {
    options.push_back({{"names", option.names},
                       {"positional", option.positional},
                       {"repeated", option.repeated},
                       {"value", option.value},
                       {"choices", option.choices},
                       {"description", option.description}});
  }
  for (const CommandEntry& part : command.commands) commands.push_back(to_json(part));
  return {{"name", command.name},
          {"summary", command.summary},
          {"options", options},
          {"commands", commands}};
}

CommandEntry parse_command_entry(const nlohmann::json& json) {
  CommandEntry command{json.at("name"), json.at("summary"), {}, {}};
  for (const nlohmann::json& option : json.at("options")) {
    command.options.push_back({option.at("names"), option.at("positional"), option.at("repeated"),
                               option.at("value"), option.at("choices"), option.at("description")});
  }
  for (const nlohmann::json& part : json.at("commands")) {
    command.commands.push_back(parse_command_entry(part));
  }
  return command;
}

}  // namespace clast
