#include "app/commands/commands.hpp"
#include "app/program.hpp"

int main(int argc, char** argv) { return clast::run_program(argc, argv, clast::add_reconstruct); }
