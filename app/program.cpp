#include "app/program.hpp"

#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "app/option_flags.hpp"
#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/printable.hpp"
#include "core/version.hpp"

namespace clast {

namespace {

constexpr int kFailed = 1;
constexpr int kMisused = 2;

/// The command that was named, or the program itself.
const CLI::App* named_command(const CLI::App* app) {
  while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
  return app;
}

/// Describes the error of CLI11, or the unknown command if a command was expected.
std::string described(const CLI::ParseError& error, const CLI::App& command) {
  const std::vector<std::string> rest = command.remaining();
  const std::vector<const CLI::App*> known = command.get_subcommands({});
  if (known.empty()) return error.what();
  std::string names;
  for (const CLI::App* subcommand : known)
    names += (names.empty() ? "" : ", ") + subcommand->get_name();
  if (rest.empty()) return "a command is missing; there are " + names;
  return "\"" + rest.front() + "\" is not a command; there are " + names;
}

int run(int argc, char** argv, const std::function<void(CLI::App&)>& add_commands) {
  CLI::App app{
      "clast: from field scans of rock blocks to rockfall simulations.\n"
      "All lengths are in metres, masses in kilograms, z is up, unless an option says "
      "otherwise.",
      "clast"};
  app.set_version_flag("--version", std::string("clast ") + version());
  app.get_formatter()->column_width(36);
  app.require_subcommand(1);
  add_commands(app);
  app.footer(
      "The usual order: reconstruct, classify, terrain, new campaign, simulate, compare.\n"
      "\"clast COMMAND --help\" explains a command and shows an example.");
  if (argc < 2) {
    std::cerr << app.help();
    return kMisused;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    const CLI::App* command = named_command(&app);
    std::cerr << "clast: " << format_for_terminal(described(error, *command))
              << "\nSee: " << full_command_name(*command) << " --help\n";
    return kMisused;
  }
  return 0;
}

/// A table that did not reach its file must not pass for done, whatever command printed it.
int checked(int exit_code) {
  std::cout.flush();
  if (std::cout || exit_code != 0) return exit_code;
  std::cerr << "clast: the output could not be written completely; is the disk full?\n";
  return kFailed;
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

}  // namespace

std::string full_command_name(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent ? full_command_name(*parent) + " " + command.get_name() : command.get_name();
}

int run_program(int argc, char** argv, const std::function<void(CLI::App&)>& add_commands) {
  // A file that grows beyond `ulimit -f` then fails as on a full disk, with a message.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return checked(run(argc, argv, add_commands));
  } catch (const Error& error) {
    std::cerr << "clast: " << format_for_terminal(error.what()) << "\n";
  } catch (const std::bad_alloc&) {
    std::cerr << "clast: not enough memory; close other programs or use a smaller input\n";
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << "clast: " << escape_nonprintable(error.path1().string()) << ": "
              << error.code().message() << "; check the path and its permissions\n";
  } catch (const std::exception& error) {
    std::cerr << "clast: unexpected failure; please report it with the command that you used: "
              << escape_nonprintable(error.what()) << "\n";
  }
  return kFailed;
}

void print_command_help(const CLI::App& app, const std::vector<std::string>& words) {
  // Not `help` of the command: that follows the commands that were typed, and so explains itself.
  const CLI::App& command = find_command(app, words);
  std::cout << command.get_formatter()->make_help(&command, full_command_name(command),
                                                  CLI::AppFormatMode::Normal);
}

}  // namespace clast
