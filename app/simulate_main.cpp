#include "app/commands/commands.hpp"
#include "app/companion.hpp"

namespace {

void add_simulate_commands(CLI::App& app) {
  clast::add_cut_command(app);
  clast::add_export_command(app);
  clast::add_terrain_command(app);
  clast::add_new_command(app);
  clast::add_check_command(app);
  clast::add_simulate_command(app);
  clast::add_compare_command(app);
  clast::add_import_command(app);
  clast::add_calibrate_command(app);
}

}  // namespace

int main(int argc, char** argv) {
  return clast::run_companion_program(argc, argv, add_simulate_commands);
}
