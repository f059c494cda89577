#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/program.hpp"

namespace {

void add_commands(CLI::App& app, char** argv) {
  const auto add_companion_commands = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) clast::add_companion_command(app, name);
  };
  // The help lists the commands in this order.
  add_companion_commands({"reconstruct", "cut"});
  clast::add_vary_command(app);
  clast::add_show_command(app);
  clast::add_classify_command(app);
  add_companion_commands({"export"});
  clast::add_library_command(app);
  add_companion_commands({"terrain", "new", "check", "simulate", "compare", "import", "calibrate"});
  clast::add_help_command(app, argv);
}

}  // namespace

int main(int argc, char** argv) {
  return clast::run_program(argc, argv, [&](CLI::App& app) {
    // Before anything is parsed: the options are known to the companion alone.
    const clast::CompanionCommand* const command =
        argc > 1 ? clast::find_companion_command(argv[1]) : nullptr;
    if (command) clast::run_companion(*command, argv);
    add_commands(app, argv);
  });
}
