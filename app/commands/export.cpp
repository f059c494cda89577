#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "core/csv_text.hpp"
#include "core/error.hpp"
#include "core/file_kind.hpp"
#include "core/number_text.hpp"
#include "core/output_file.hpp"
#include "core/printable.hpp"
#include "library/block_library.hpp"
#include "library/unscaled.hpp"
#include "mesh/mesh_io.hpp"
#include "shapes/coplanar_faces.hpp"
#include "shapes/outer_skin.hpp"
#include "shapes/shp_file.hpp"

namespace clast {

namespace {

const std::vector<std::string> kFormats = {"shp", "obj", "stl", "ply", "glb", "vtp"};

struct ExportArgs {
  std::string library;
  std::vector<std::string> ids;
  std::string folder = "export";
  std::string formats = "shp";
  std::string what = "skin";
  std::string frame = "source";
  std::string up = "z";
  int segments = 4;
  bool replace = false;
  bool segments_given = false;
};

/// z up to y up, the inverse of what `--up y` does on reading.
TriangleMesh turned_y_up(TriangleMesh mesh) {
  for (Vec3& vertex : mesh.vertices) vertex = Vec3(vertex.x(), vertex.z(), -vertex.y());
  return mesh;
}

ShpShape shp_shape(const Block& block) {
  ShpShape shape;
  shape.name = block.id;
  std::replace_if(
      shape.name.begin(), shape.name.end(), [](char c) { return c == ' '; }, '_');
  shape.source_from_body = block.source_from_body();
  const Pose body_from_source = shape.source_from_body.inverse();
  shape.body = transformed(with_merged_faces(block.body, kFlatInFiles), body_from_source);
  shape.volume = block.mass.volume;
  shape.inertia_per_mass = block.principal.moments / block.mass.mass;
  shape.box = block.box;
  shape.box.centre = body_from_source * block.box.centre;
  shape.box.axes = body_from_source.rotation.toRotationMatrix() * block.box.axes;
  return shape;
}

/// What `--what` names, by what is added to the id for the file's name.
std::vector<std::pair<std::string, TriangleMesh>> chosen_meshes(const Block& block,
                                                                const ExportArgs& args) {
  if (args.what == "surface") return {{"", block.surface}};
  if (args.what == "skin") return {{"", outer_skin(block.body, args.segments)}};
  if (block.body.faces.empty()) {
    throw GeometryError("block " + block.id +
                        " is a ball or a capsule, whose core is no mesh; use --what skin");
  }
  const TriangleMesh core = core_mesh(block.body);
  if (args.what == "core") return {{"", core}};
  return {{"", outer_skin(block.body, args.segments)}, {"_core", core}};
}

/// What `chosen_meshes` adds to the id for the names of its files.
std::vector<std::string> suffixes(const ExportArgs& args) {
  if (args.what == "both") return {"", "_core"};
  return {""};
}

std::filesystem::path mesh_file(const ExportArgs& args, const Block& block,
                                const std::string& suffix, const std::string& format) {
  return std::filesystem::path(args.folder) / (block.id + suffix + "." + format);
}

OutputRules rules_of(const std::filesystem::path& file, const ExportArgs& args, bool checked) {
  return {.kind = kind_by_name(file), .replace = args.replace, .checked = checked};
}

/// Checks that no file to be written would replace another, such as the scan that the block was
/// made from.
void check_places(const ExportArgs& args, const std::vector<const Block*>& blocks,
                  const std::vector<std::string>& formats) {
  for (const Block* block : blocks) {
    for (const std::string& format : formats) {
      for (const std::string& suffix :
           format == "shp" ? std::vector<std::string>{""} : suffixes(args)) {
        const std::filesystem::path file = mesh_file(args, *block, suffix, format);
        check_mesh_output(file, rules_of(file, args, false));
      }
    }
  }
}

/// Reports that more `--segments` than have an effect were asked for.
void report_segments(const Block& block, const ExportArgs& args) {
  const std::optional<double> length = wrap_length(block.body, args.segments);
  const int most = most_wrap_segments(block.body);
  if (!args.segments_given || !length || args.segments <= most) return;
  std::cerr << "block " << printable(block.id)
            << " is concave: its skin is wrapped in triangles of " << with_digits(*length, 3)
            << (is_unscaled(block) ? " units" : " m")
            << ", the shortest allowed (1/150 of its diagonal), so --segments " << args.segments
            << " gives the same skin as " << most << "\n";
}

void export_blocks(const ExportArgs& args) {
  if (args.folder.empty()) throw CLI::ValidationError("--output", "names no folder");
  const std::vector<std::string> formats = split_list(args.formats);
  for (const std::string& format : formats) {
    if (std::find(kFormats.begin(), kFormats.end(), format) == kFormats.end()) {
      throw CLI::ValidationError("--format", "\"" + format +
                                                 "\" is not known; expected shp, obj, stl, ply, "
                                                 "glb or vtp");
    }
  }
  if (formats.empty()) throw CLI::ValidationError("--format", "names no format");
  const bool only_shp = formats == std::vector<std::string>{"shp"};
  const bool skin = !only_shp && (args.what == "skin" || args.what == "both");
  if (args.segments_given && !skin) {
    throw CLI::ValidationError("--segments",
                               "applies to the rounded skin in a mesh file, and none is written; "
                               "add for example --format ply --what skin");
  }
  if (args.frame == "principal" && args.up == "y") {
    throw CLI::ValidationError("--up", "y turns the source frame; the principal frame has no up");
  }
  const BlockLibrary library = BlockLibrary::read(args.library);
  std::vector<const Block*> blocks;
  for (const std::string& id : args.ids) blocks.push_back(&library.block(id));
  if (args.ids.empty()) {
    for (const Block& block : library.blocks()) blocks.push_back(&block);
  }

  if (blocks.empty()) throw InputError(args.library + ": there is no block in it to export");
  check_places(args, blocks, formats);
  std::size_t written = 0;
  for (const Block* block : blocks) {
    if (is_unscaled(*block)) {
      std::cerr << "block " << printable(block->id)
                << " is unscaled, so its exported coordinates are not in "
                << "metres: " << unscaled_reason() << "\n";
    }
    std::vector<std::pair<std::string, TriangleMesh>> meshes;
    if (skin) report_segments(*block, args);
    if (!only_shp) meshes = chosen_meshes(*block, args);
    for (auto& [suffix, mesh] : meshes) {
      if (args.frame == "principal") {
        mesh = transformed(std::move(mesh), block->source_from_body().inverse());
      }
      if (args.up == "y") mesh = turned_y_up(std::move(mesh));
    }
    for (const std::string& format : formats) {
      if (format == "shp") {
        const ShpShape shape = shp_shape(*block);
        const std::filesystem::path file = mesh_file(args, *block, "", format);
        write_shp(file, {&shape, 1}, rules_of(file, args, true));
        ++written;
        continue;
      }
      for (const auto& [suffix, mesh] : meshes) {
        const std::filesystem::path file = mesh_file(args, *block, suffix, format);
        const Vec3 origin = write_mesh(file, mesh, {.rules = rules_of(file, args, true)});
        ++written;
        if (!origin.isZero(0.0)) {
          std::cerr << printable(file.string())
                    << ": its floats can't hold coordinates this far out, so " << place(origin)
                    << " was subtracted (see " << printable(file.filename().string())
                    << ".origin.txt); obj, ply and vtp keep them\n";
        }
      }
    }
  }
  std::cout << printable(args.folder) << ": " << counted(written, "file") << " of "
            << counted(blocks.size(), "block") << " written\n";
}

}  // namespace

void add_export(CLI::App& app) {
  const auto args = std::make_shared<ExportArgs>();
  CLI::App* command = app.add_subcommand("export", "Export blocks for other tools");
  command->add_option("library", args->library, "Block library")->required()->type_name("LIB");
  command->add_option("ids", args->ids, "Blocks to export; without: all")->type_name("ID");
  command
      ->add_option("-o,--output", args->folder, "Folder, created if missing; a file for each block")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_flag("--replace", args->replace, "Replace existing files");
  command
      ->add_option("--format", args->formats,
                   "Comma-separated: shp (Rockable, ExaDEM), obj, stl, ply, glb, vtp")
      ->type_name("LIST")
      ->capture_default_str();
  command
      ->add_option("--what", args->what,
                   "What mesh files hold: the rounded skin, the core, both (a second file "
                   "ID_core), or surface, the simplified scan the block was made from")
      ->check(CLI::IsMember({"skin", "core", "both", "surface"}))
      ->type_name("NAME")
      ->capture_default_str();
  CLI::Option* segments =
      command
          ->add_option(
              "--segments", args->segments,
              "Segments of a quarter turn in the skin, 1 to 64; its volume is too small by a "
              "share that falls with their square. A concave block's skin has no triangles below "
              "1/150 of its diagonal")
          ->check(whole_number(1, 64))
          ->type_name("N")
          ->capture_default_str();
  command
      ->add_option("--frame", args->frame,
                   "Frame of mesh files: source, that of the scan, or principal, origin at the "
                   "centre of mass as in shp files")
      ->check(CLI::IsMember({"source", "principal"}))
      ->type_name("NAME")
      ->capture_default_str();
  command->add_option("--up", args->up, "Up axis of mesh files: z as stored, or y")
      ->check(CLI::IsMember({"y", "z"}))
      ->type_name("AXIS")
      ->capture_default_str();
  command->footer(
      "Mesh files are in metres. shp files hold core and radius in metres in the principal frame, "
      "origin at\nthe centre of mass, faces in one plane as one polygon, and where the scan had "
      "that frame.\n"
      "Example:\n  clast export blocks.h5 SP1A SP3A -o shapes --format shp,stl");
  command->callback([args, segments] {
    args->segments_given = segments->count() > 0;
    export_blocks(*args);
  });
}

}  // namespace clast
