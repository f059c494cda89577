#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>

#include "app/commands/commands.hpp"
#include "app/option_flags.hpp"
#include "core/files/output_folder.hpp"
#include "core/printable.hpp"
#include "library/block_library.hpp"
#include "report/blocks/gallery.hpp"
#include "report/json/block_json.hpp"
#include "report/text/block_text.hpp"

namespace clast {

namespace {

namespace fs = std::filesystem;

struct ShowArgs {
  std::string library;
  std::vector<std::string> ids;
  bool json = false;
  std::string report;
  bool replace = false;
};

void print_details(const Block& block) {
  constexpr std::size_t kNames = 26;  // characters
  std::cout << "\n" << escape_nonprintable(block.id) << "\n";
  for (const auto& [name, value] : describe_block(block)) {
    std::cout << "  " << name << std::string(name.size() < kNames ? kNames - name.size() : 1, ' ')
              << format_for_terminal(value) << "\n";
  }
}

void print_shown_blocks(const ShowArgs& args, std::span<const Block* const> blocks) {
  if (args.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Block* block : blocks) all.push_back(block_json(*block));
    std::cout << all.dump(2) << "\n";
    return;
  }
  std::cout << make_block_table(blocks).text();
  const std::string note = describe_unscaled_blocks(blocks);
  if (!note.empty()) std::cout << "\n" << format_for_terminal(note) << "\n";
  if (args.ids.empty()) return;
  for (const Block* block : blocks) print_details(*block);
}

void show(const ShowArgs& args) {
  std::optional<OutputFolder> folder;
  if (!args.report.empty()) folder.emplace(args.report, gallery_folder_kind(), args.replace);
  const BlockLibrary library = BlockLibrary::read(args.library);
  const std::vector<const Block*> blocks = library.select_blocks(args.ids);
  if (folder) {
    const fs::path name = fs::path(args.library).filename();
    write_gallery(blocks, "Blocks of " + escape_nonprintable(name.string()),
                  folder->temporary_path());
    folder->commit();
  }
  print_shown_blocks(args, blocks);
  if (folder && !args.json) {
    std::cout << "\nReport: "
              << escape_nonprintable((fs::path(args.report) / "gallery.html").string()) << "\n";
  }
}

}  // namespace

void add_show_command(CLI::App& app) {
  const auto args = std::make_shared<ShowArgs>();
  CLI::App* command = app.add_subcommand("show", "Show the blocks of a library");
  command->add_option("library", args->library, "Block library")->required()->type_name("LIB");
  command->add_option("ids", args->ids, "Blocks to show in full; default: one line per block")
      ->type_name("ID");
  command->add_flag("--json", args->json, "Print all data of the blocks as JSON");
  CLI::Option* report =
      command
          ->add_option("--report", args->report,
                       "Folder for a page with a picture, the numbers and a 3-D view of each "
                       "block, created if missing")
          ->type_name("DIR");
  command->add_flag("--replace", args->replace, "Replace an existing page in the folder")
      ->needs(report);
  command->footer(
      "Lengths in m, volumes in m3, masses in kg, moments of inertia in kg m2 about the "
      "centre of mass.\nL, I, S are the sides of the smallest box, s_c = L/I - 1.\n"
      "Examples:\n  clast show blocks.h5\n  clast show blocks.h5 SP1A --json\n"
      "  clast show blocks.h5 --report gallery");
  command->callback([args, report] {
    if (report->count() > 0 && args->report.empty()) {
      throw CLI::ValidationError("--report", "names no folder");
    }
    show(*args);
  });
}

}  // namespace clast
