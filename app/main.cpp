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
                return clast::parse_command_entry(nlohmann::json::parse(text)).commands.front();
              }};
}

void add_main_commands(CLI::App& app, char** argv) {
  app.add_subcommand("reconstruct", clast::kReconstructSummary)->callback([argv] {
    clast::run_companion(argv);
  });
  clast::add_cut_command(app);
  clast::add_vary_command(app);
  clast::add_show_command(app);
  clast::add_classify_command(app);
  clast::add_export_command(app);
  clast::add_library_command(app);
  clast::add_terrain_command(app);
  clast::add_new_command(app);
  clast::add_check_command(app);
  clast::add_simulate_command(app);
  clast::add_compare_command(app);
  clast::add_import_command(app);
  clast::add_calibrate_command(app);
  clast::add_help_command(app, help_of_reconstruct(argv[0]));
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
