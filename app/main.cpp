#include <nlohmann/json.hpp>
#include <string_view>

#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/program.hpp"

namespace {

/// Help of the command that only the companion has.
clast::ReconstructHelp help_of_reconstruct(const char* program) {
  return {.show =
              [program] {
                std::string words[] = {program, "reconstruct", "--help"};
                char* argv[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
                clast::run_companion(argv);
              },
          .options =
              [] {
                const std::string text = clast::read_companion_output(clast::kDescribeCommand);
                return clast::command_from_json(nlohmann::json::parse(text)).commands.front();
              }};
}

void add_main_commands(CLI::App& app, char** argv) {
  app.add_subcommand("reconstruct", clast::kReconstructSummary)->callback([argv] {
    clast::run_companion(argv);
  });
  clast::add_cut(app);
  clast::add_vary(app);
  clast::add_show(app);
  clast::add_classify(app);
  clast::add_export(app);
  clast::add_library(app);
  clast::add_terrain(app);
  clast::add_new(app);
  clast::add_check(app);
  clast::add_simulate(app);
  clast::add_compare(app);
  clast::add_import(app);
  clast::add_calibrate(app);
  clast::add_help(app, help_of_reconstruct(argv[0]));
}

}  // namespace

int main(int argc, char** argv) {
  const bool reconstruct = argc > 1 && std::string_view(argv[1]) == "reconstruct";
  return clast::run_program(argc, argv, [&](CLI::App& app) {
    // Before anything is parsed: the options are known to the companion alone.
    if (reconstruct) clast::run_companion(argv);
    add_main_commands(app, argv);
  });
}
