#include <string_view>

#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/program.hpp"

namespace {

void add_commands(CLI::App& app, char** argv) {
  app.add_subcommand("reconstruct", clast::kReconstructSummary)->callback([argv] {
    clast::run_companion(argv);
  });
  clast::add_cut(app);
  clast::add_show(app);
  clast::add_classify(app);
  clast::add_export(app);
  clast::add_library(app);
  clast::add_terrain(app);
  clast::add_simulate(app);
  clast::add_compare(app);
}

}  // namespace

int main(int argc, char** argv) {
  const bool reconstruct = argc > 1 && std::string_view(argv[1]) == "reconstruct";
  return clast::run_program(argc, argv, [&](CLI::App& app) {
    // Before anything is parsed: the options are known to the companion alone.
    if (reconstruct) clast::run_companion(argv);
    add_commands(app, argv);
  });
}
