#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/commands/commands.hpp"
#include "app/option_flags.hpp"
#include "core/printable.hpp"
#include "library/block_library.hpp"
#include "report/json/block_json.hpp"
#include "report/text/block_text.hpp"

namespace clast {

namespace {

struct ShowArgs {
  std::string library;
  std::vector<std::string> ids;
  bool json = false;
};

/// What the table leaves out.
void print_details(const Block& block) {
  constexpr std::size_t kNames = 26;  // characters
  std::cout << "\n" << printable(block.id) << "\n";
  for (const auto& [name, value] : block_details(block)) {
    std::cout << "  " << name << std::string(name.size() < kNames ? kNames - name.size() : 1, ' ')
              << shown(value) << "\n";
  }
}

void show(const ShowArgs& args) {
  const BlockLibrary library = BlockLibrary::read(args.library);
  const std::vector<const Block*> blocks = library.chosen(args.ids);
  if (args.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Block* block : blocks) all.push_back(block_json(*block));
    std::cout << all.dump(2) << "\n";
    return;
  }
  std::cout << block_table(blocks).text();
  const std::string note = unscaled_note(blocks);
  if (!note.empty()) std::cout << "\n" << shown(note) << "\n";
  if (args.ids.empty()) return;
  for (const Block* block : blocks) print_details(*block);
}

}  // namespace

void add_show(CLI::App& app) {
  const auto args = std::make_shared<ShowArgs>();
  CLI::App* command = app.add_subcommand("show", "Show what a library holds");
  command->add_option("library", args->library, "Block library")->required()->type_name("LIB");
  command->add_option("ids", args->ids, "Blocks to show in full; default: one line per block")
      ->type_name("ID");
  command->add_flag("--json", args->json, "Print all data of the blocks as JSON");
  command->footer(
      "Lengths in m, volumes in m3, masses in kg, moments of inertia in kg m2 about the "
      "centre of mass.\nL, I, S are the sides of the smallest box, s_c = L/I - 1.\n"
      "Examples:\n  clast show blocks.h5\n  clast show blocks.h5 SP1A --json");
  command->callback([args] { show(*args); });
}

}  // namespace clast
