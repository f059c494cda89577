#include "app/commands/commands.hpp"
#include "app/companion.hpp"

int main(int argc, char** argv) {
  return clast::run_companion_program(argc, argv, clast::add_reconstruct_command);
}
