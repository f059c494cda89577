#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/scene_export.hpp"
#include "app/companion.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "library/block_export.hpp"
#include "library/block_library.hpp"

namespace clast {

namespace {

struct ExportArgs {
  std::string library;
  std::vector<std::string> ids;
  std::string folder = "export";
  std::string formats = "shp";
  std::string what = "skin";
  std::string frame = "source";
  int segments = 4;
  BlockExportOptions options;
  SceneExportArgs scene;
};

const std::map<std::string, ExportedSurface> kSurfaces = {{"skin", ExportedSurface::kSkin},
                                                          {"core", ExportedSurface::kCore},
                                                          {"both", ExportedSurface::kBoth},
                                                          {"surface", ExportedSurface::kSurface}};
const std::map<std::string, ExportFrame> kFrames = {{"source", ExportFrame::kSource},
                                                    {"principal", ExportFrame::kPrincipal}};

/// Scenes have a format of their own.
void check_scene_usage(const CLI::App& command) {
  for (const char* option : {"ids", "--format", "--what", "--segments", "--frame", "--up"}) {
    if (command.count(option) == 0) continue;
    throw CLI::ValidationError(option, "applies to blocks of a library, not to scenes (--to)");
  }
}

void run_export(const ExportArgs& args) {
  if (args.folder.empty()) throw CLI::ValidationError("--output", "names no folder");
  check_usage([&] { args.options.check(); });
  if (args.options.segments && !args.options.includes_rounded_surface()) {
    throw CLI::ValidationError("--segments",
                               "applies to the rounded skin in a mesh file, and none is written; "
                               "add for example --format ply --what skin");
  }
  const BlockLibrary library = BlockLibrary::read(args.library);
  const std::vector<const Block*> blocks = library.select_blocks(args.ids);
  if (blocks.empty()) throw InputError(args.library + ": holds no block to export");
  const std::vector<std::filesystem::path> written = export_blocks(
      blocks, args.folder, args.options,
      [](const std::string& text) { std::cerr << format_for_terminal(text) << "\n"; });
  std::cout << escape_nonprintable(args.folder) << ": " << format_count(written.size(), "file")
            << " of " << format_count(blocks.size(), "block") << " written\n";
}

void add_format_options(CLI::App& command, ExportArgs& args) {
  command
      .add_option("--format", args.formats,
                  "Comma-separated: shp (Rockable, ExaDEM), obj, stl, ply, glb, vtp")
      ->type_name("LIST")
      ->capture_default_str();
  command
      .add_option("--what", args.what,
                  "Content of mesh files: the rounded skin, the core, both (a second file "
                  "ID_core), or surface, the simplified scan from which the block was made")
      ->check(CLI::IsMember({"skin", "core", "both", "surface"}))
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option("--segments", args.segments,
                  "Segments per quarter circle of the skin, 1 to 64; the error of its volume "
                  "decreases with N squared. The skin of a concave block has no triangles smaller "
                  "than 1/150 of its diagonal")
      ->check(integer_in_range(1, 64))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--frame", args.frame,
                  "Frame of mesh files: source (that of the scan) or principal (origin at the "
                  "centre of mass, as in shp files)")
      ->check(CLI::IsMember({"source", "principal"}))
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option("--up", args.options.up,
                  "Up axis of mesh files: z as stored, y, or auto (y in glb, as its standard "
                  "requires, z in all others)")
      ->check(CLI::IsMember({"auto", "y", "z"}))
      ->type_name("AXIS")
      ->capture_default_str();
}

}  // namespace

void add_export_command(CLI::App& app) {
  const auto args = std::make_shared<ExportArgs>();
  CLI::App* command = &add_companion_command(app, "export");
  command->add_option("library", args->library, "Block library; with --to, a campaign file")
      ->required()
      ->type_name("LIB");
  command->add_option("ids", args->ids, "Blocks to export; default: all")->type_name("ID");
  command
      ->add_option("-o,--output", args->folder,
                   "Output folder, created if missing, with a file for each block or a folder for "
                   "each scene")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("--replace", args->options.replace, "Replace existing files");
  add_format_options(*command, *args);
  add_scene_options(*command, args->scene);
  command->footer(
      "Mesh files are in metres. shp files contain the core and the radius in metres, in the "
      "principal frame.\nThe origin of this frame is the centre of mass, and the file states its "
      "pose in the scan.\nScenes (--to) contain blocks, terrain, starts and contact parameters of "
      "each run for Rockable or ExaDEM.\nFeatures that these formats can't express are listed.\n"
      "Examples:\n  clast export blocks.h5 SP1A SP3A -o shapes --format shp,stl\n"
      "  clast export campaign.toml --to rockable --runs 0-15 -o scenes");
  command->callback([args, command] {
    if (!args->scene.engine.empty()) {
      if (args->folder.empty()) throw CLI::ValidationError("--output", "names no folder");
      check_scene_usage(*command);
      return export_scenes(args->library, args->folder, args->options.replace, args->scene);
    }
    if (!args->scene.runs.empty()) {
      throw CLI::ValidationError("--runs", "applies to scenes of a campaign (--to)");
    }
    args->options.formats = split_comma_separated(args->formats);
    args->options.surface = kSurfaces.at(args->what);
    args->options.frame = kFrames.at(args->frame);
    if (command->count("--segments") > 0) args->options.segments = args->segments;
    run_export(*args);
  });
}

}  // namespace clast
