#include <iostream>
#include <memory>

#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/program.hpp"
#include "app/shell_completion.hpp"

namespace clast {

namespace {

struct HelpArgs {
  std::vector<std::string> command;
  std::string completion;
};

/// The tables of all commands, with those of companion executables from where they are.
CommandEntry whole_tree(const CLI::App& app) {
  CommandEntry root = build_command_tree(app);
  for (CommandEntry& part : root.commands) {
    const CompanionCommand* const command = find_companion_command(part.name);
    if (command) part = read_companion_options(*command);
  }
  return root;
}

void help(const CLI::App& app, char** argv, const HelpArgs& args) {
  const CompanionCommand* const elsewhere =
      args.command.empty() ? nullptr : find_companion_command(args.command.front());
  if (args.completion == "bash") {
    std::cout << make_bash_completion(whole_tree(app));
  } else if (args.completion == "zsh") {
    std::cout << make_zsh_completion(whole_tree(app));
  } else if (elsewhere) {
    run_companion(*elsewhere, argv);
  } else {
    print_command_help(app, args.command);
  }
}

}  // namespace

void add_help_command(CLI::App& app, char** argv) {
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
  command->callback([&app, argv, args] { help(app, argv, *args); });
}

}  // namespace clast
