#include <iostream>
#include <memory>

#include "app/commands/commands.hpp"
#include "app/program.hpp"
#include "app/shell_completion.hpp"
#include "core/comma_separated.hpp"

namespace clast {

namespace {

struct HelpArgs {
  std::vector<std::string> command;
  std::string completion;
};

/// The tables of all commands, with those of `reconstruct` from where they are.
CommandEntry whole_tree(const CLI::App& app, const ReconstructHelp& reconstruct) {
  CommandEntry root = build_command_tree(app);
  for (CommandEntry& part : root.commands) {
    if (part.name == "reconstruct") part = reconstruct.options();
  }
  return root;
}

const CLI::App& find_command(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  for (const std::string& word : words) {
    std::vector<std::string> known;
    const CLI::App* found = nullptr;
    for (const CLI::App* part : command->get_subcommands({})) {
      known.push_back(part->get_name());
      if (part->get_name() == word) found = part;
    }
    if (!found) {
      throw CLI::ValidationError("\"" + word + "\" is not a command" +
                                 (known.empty() ? " below " + command->get_name()
                                                : "; there are " + comma_separated(known)));
    }
    command = found;
  }
  return *command;
}

void help(const CLI::App& app, const ReconstructHelp& reconstruct, const HelpArgs& args) {
  if (args.completion == "bash") {
    std::cout << make_bash_completion(whole_tree(app, reconstruct));
  } else if (args.completion == "zsh") {
    std::cout << make_zsh_completion(whole_tree(app, reconstruct));
  } else if (!args.command.empty() && args.command.front() == "reconstruct") {
    reconstruct.show();
  } else {
    // Not `help` of the command: that follows the commands that were typed, and so explains itself.
    const CLI::App& command = find_command(app, args.command);
    std::cout << command.get_formatter()->make_help(&command, full_command_name(command),
                                                    CLI::AppFormatMode::Normal);
  }
}

}  // namespace

void add_help_command(CLI::App& app, const ReconstructHelp& reconstruct) {
  const auto args = std::make_shared<HelpArgs>();
  CLI::App* command = app.add_subcommand("help", "Explain a command; print shell completion");
  CLI::Option* words = command->add_option("command", args->command, "Command, one or two words")
                           ->type_name("COMMAND");
  command
      ->add_option("--completion", args->completion,
                   "Print the script for command completion in a shell")
      ->check(CLI::IsMember({"bash", "zsh"}))
      ->type_name("SHELL")
      ->excludes(words);
  command->footer(
      "Manual pages and completion are installed with the program.\n"
      "Examples:\n"
      "  clast help simulate\n"
      "  clast help --completion bash > ~/.local/share/bash-completion/completions/clast");
  command->callback([&app, reconstruct, args] { help(app, reconstruct, *args); });
}

}  // namespace clast
