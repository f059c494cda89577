#include "app/companion.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/program.hpp"
#include "core/error.hpp"

namespace clast {

namespace {

namespace fs = std::filesystem;

constexpr const char *kSimulate = "clast-simulate", *kReconstruct = "clast-reconstruct";
constexpr CompanionCommand kCommands[] = {
    {"reconstruct",
     "Turn scans (meshes, point clouds, photographs) into blocks of a library, repairing defects",
     kReconstruct},
    {"cut", "Cut a rock mass into its blocks by joint sets", kSimulate},
    {"export", "Export blocks, or a campaign, for other tools", kSimulate},
    {"terrain", "Check a surveyed terrain with its zones and prepare it for simulation", kSimulate},
    {"new", "Write a first campaign file to edit", kSimulate},
    {"check", "List all errors in a campaign or calibration study, without running it", kSimulate},
    {"simulate", "Run a campaign of releases", kSimulate},
    {"compare", "Compare runs by block shape and class: tables, map layers and an HTML report",
     kSimulate},
    {"import",
     "Convert the results of another engine for exported scenes to a results file for compare",
     kSimulate},
    {"calibrate", "Estimate ground parameters from field observations, with their uncertainty",
     kSimulate},
};

/// Argument with which a companion executable prints its options as JSON.
constexpr const char* kDescribeCommand = "describe";

/// Beside the program in a build folder, and where it is installed to.
fs::path find_executable(const CompanionCommand& command) {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const fs::path beside = program.parent_path() / command.program;
  const fs::path installed = program.parent_path() / CLAST_COMPANION_FOLDER / command.program;
  for (const fs::path& path : {beside, installed}) {
    if (fs::is_regular_file(path)) return path;
  }
  const std::string package = command.program == kReconstruct ? kReconstruct : "clast";
  throw InputError(beside.string() + ": is missing, also in " + installed.parent_path().string() +
                   "; clast " + command.name + " needs this program: install the package " +
                   package + ", or keep the programs in one folder");
}

[[noreturn]] void refuse_start(const fs::path& path) {
  throw InputError(path.string() + ": can't be started (" + std::strerror(errno) +
                   "); install clast and clast-reconstruct again");
}

std::string read_output(const fs::path& path, const std::string& argument) {
  std::string program = path.string(), word = argument;
  int ends[2];
  if (::pipe(ends) != 0) refuse_start(path);
  const ::pid_t child = ::fork();
  if (child < 0) refuse_start(path);
  if (child == 0) {
    char* argv[] = {program.data(), word.data(), nullptr};
    if (::dup2(ends[1], STDOUT_FILENO) >= 0 && ::close(ends[0]) == 0) ::execv(argv[0], argv);
    ::_exit(126);
  }
  ::close(ends[1]);
  std::string output;
  char buffer[4096];
  for (::ssize_t read; (read = ::read(ends[0], buffer, sizeof buffer)) > 0;) {
    output.append(buffer, static_cast<std::size_t>(read));
  }
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw InputError(path.string() +
                     ": does not describe its options; install clast and clast-reconstruct again");
  }
  return output;
}

}  // namespace

const CompanionCommand* find_companion_command(std::string_view name) {
  const auto* const found =
      std::find_if(std::begin(kCommands), std::end(kCommands),
                   [&](const CompanionCommand& command) { return command.name == name; });
  return found == std::end(kCommands) ? nullptr : found;
}

CLI::App& add_companion_command(CLI::App& app, std::string_view name) {
  const CompanionCommand& command = *find_companion_command(name);
  return *app.add_subcommand(command.name, command.summary);
}

void run_companion(const CompanionCommand& command, char** argv) {
  const fs::path path = find_executable(command);
  ::execv(path.c_str(), argv);
  refuse_start(path);
}

CommandEntry read_companion_options(const CompanionCommand& command) {
  const std::string text = read_output(find_executable(command), kDescribeCommand);
  const CommandEntry root = parse_command_entry(nlohmann::json::parse(text));
  return *std::find_if(root.commands.begin(), root.commands.end(),
                       [&](const CommandEntry& entry) { return entry.name == command.name; });
}

int run_companion_program(int argc, char** argv,
                          const std::function<void(CLI::App&)>& add_commands) {
  return run_program(argc, argv, [&](CLI::App& app) {
    add_commands(app);
    const auto words = std::make_shared<std::vector<std::string>>();
    CLI::App* help = app.add_subcommand("help", "")->group("");
    help->add_option("command", *words);
    help->callback([&app, words] { print_command_help(app, *words); });
    app.add_subcommand(kDescribeCommand, "")->group("")->callback([&app] {
      std::cout << to_json(build_command_tree(app)).dump() << "\n";
    });
  });
}

}  // namespace clast
