#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_tree.hpp"
#include "app/commands/commands.hpp"
#include "app/companion.hpp"
#include "app/program.hpp"

namespace {

void add_reconstruct_commands(CLI::App& app) {
  clast::add_reconstruct_command(app);
  app.add_subcommand(clast::kDescribeCommand, "")->group("")->callback([&app] {
    std::cout << clast::to_json(clast::build_command_tree(app)).dump() << "\n";
  });
}

}  // namespace

int main(int argc, char** argv) { return clast::run_program(argc, argv, add_reconstruct_commands); }
