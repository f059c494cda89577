#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/commands/particle_export.hpp"
#include "app/commands/scene_export.hpp"
#include "app/companion.hpp"
#include "app/option_flags.hpp"
#include "app/option_values.hpp"
#include "core/comma_separated.hpp"
#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "library/block_export.hpp"
#include "library/block_library.hpp"
#include "study/engines/engine_scene.hpp"

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
  std::string engine;  ///< if empty, mesh and shape files are written
  SceneExportArgs scene;
  ParticleExportArgs particles;
};

const std::map<std::string, ExportedSurface> kSurfaces = {{"skin", ExportedSurface::kSkin},
                                                          {"core", ExportedSurface::kCore},
                                                          {"both", ExportedSurface::kBoth},
                                                          {"surface", ExportedSurface::kSurface}};
const std::map<std::string, ExportFrame> kFrames = {{"source", ExportFrame::kSource},
                                                    {"principal", ExportFrame::kPrincipal}};

bool is_scene_engine(const std::string& engine) {
  const std::vector<std::string>& engines = exportable_engines();
  return std::find(engines.begin(), engines.end(), engine) != engines.end();
}

/// Scenes, particles, and mesh files have options of their own.
void check_usage_of_engine(const CLI::App& command, const std::string& engine) {
  const auto refuse = [&](const std::vector<std::string>& options, const std::string& reason) {
    for (const std::string& option : options) {
      if (command.count(option) > 0) throw CLI::ValidationError(option, reason);
    }
  };
  if (engine.empty() || is_scene_engine(engine)) {
    refuse(particle_option_names(), "applies to particles of an engine; add for example --to yade");
  }
  if (engine.empty() || !is_scene_engine(engine)) {
    refuse({"--runs"}, "applies to scenes of a campaign (--to rockable, --to exadem)");
  }
  if (engine.empty()) return;
  refuse({"--format", "--what", "--segments", "--frame", "--up"},
         "applies to mesh and shape files of blocks, not with --to");
  if (is_scene_engine(engine))
    refuse({"ids"}, "applies to blocks of a library, not to scenes (--to)");
}

std::vector<std::string> engine_names() {
  std::vector<std::string> names = exportable_engines();
  for (const std::string& name : particle_engine_names()) names.push_back(name);
  return names;
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
  command
      ->add_option("library", args->library,
                   "Block library; with --to rockable or exadem, a campaign file")
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
  command
      ->add_option("--to", args->engine,
                   "Write files for another engine: scenes of a campaign for rockable or exadem; "
                   "blocks of a library as particles for " +
                       comma_separated(particle_engine_names()))
      ->check(CLI::IsMember(engine_names()).description(""))  // a list too long for its column
      ->type_name("ENGINE");
  add_scene_options(*command, args->scene);
  add_particle_options(*command, args->particles);
  command->footer(
      "Mesh files are in metres. shp files contain the core and the radius in metres, in the "
      "principal frame.\nThe origin of this frame is the centre of mass, and the file states its "
      "pose in the scan.\nScenes (--to) contain blocks, terrain, starts and contact parameters of "
      "each run for Rockable or ExaDEM.\nFeatures that these formats can't express are listed.\n"
      "Particles (--to yade, lammps, ...) replace each block by spheres, convex parts or its hull "
      "to a stated\nerror, with the mass and inertia of the block. A repeated command continues an "
      "interrupted export.\n"
      "Examples:\n  clast export blocks.h5 SP1A SP3A -o shapes --format shp,stl\n"
      "  clast export campaign.toml --to rockable --runs 0-15 -o scenes\n"
      "  clast export blocks.h5 --to yade --error surface=0.03 -o clumps");
  command->callback([args, command] {
    check_usage_of_engine(*command, args->engine);
    if (args->folder.empty()) throw CLI::ValidationError("--output", "names no folder");
    if (is_scene_engine(args->engine)) {
      args->scene.engine = args->engine;
      return export_scenes(args->library, args->folder, args->options.replace, args->scene);
    }
    if (!args->engine.empty()) {
      args->particles.options.engine = args->engine;
      args->particles.options.replace = args->options.replace;
      return run_particle_export(args->library, args->ids, args->folder, args->particles);
    }
    args->options.formats = split_comma_separated(args->formats);
    args->options.surface = kSurfaces.at(args->what);
    args->options.frame = kFrames.at(args->frame);
    if (command->count("--segments") > 0) args->options.segments = args->segments;
    run_export(*args);
  });
}

}  // namespace clast
