#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/commands/commands.hpp"
#include "app/option_values.hpp"
#include "app/text_table.hpp"
#include "library/block_library.hpp"
#include "shapes/mesh_io.hpp"
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
  std::string up = "z";
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
  shape.body = transformed(block.body, body_from_source);
  shape.volume = block.mass.volume;
  shape.inertia_per_mass = block.principal.moments / block.mass.mass;
  shape.box = block.box;
  shape.box.centre = body_from_source * block.box.centre;
  shape.box.axes = body_from_source.rotation.toRotationMatrix() * block.box.axes;
  return shape;
}

void export_blocks(const ExportArgs& args) {
  const std::vector<std::string> formats = split_list(args.formats);
  for (const std::string& format : formats) {
    if (std::find(kFormats.begin(), kFormats.end(), format) == kFormats.end()) {
      throw CLI::ValidationError("--format", "\"" + format +
                                                 "\" is not known; expected shp, obj, stl, ply, "
                                                 "glb or vtp");
    }
  }
  if (formats.empty()) throw CLI::ValidationError("--format", "names no format");
  const BlockLibrary library = BlockLibrary::read(args.library);
  std::vector<const Block*> blocks;
  for (const std::string& id : args.ids) blocks.push_back(&library.block(id));
  if (args.ids.empty()) {
    for (const Block& block : library.blocks()) blocks.push_back(&block);
  }

  std::size_t written = 0;
  for (const Block* block : blocks) {
    const auto write = [&](const TriangleMesh& mesh, const std::string& name) {
      write_mesh(std::filesystem::path(args.folder) / name,
                 args.up == "y" ? turned_y_up(mesh) : mesh);
      ++written;
    };
    for (const std::string& format : formats) {
      if (format == "shp") {
        const ShpShape shape = shp_shape(*block);
        write_shp(std::filesystem::path(args.folder) / (block->id + ".shp"), {&shape, 1});
        ++written;
        continue;
      }
      if (args.what != "core") write(skin_mesh(block->body), block->id + "." + format);
      if (args.what == "core") write(core_mesh(block->body), block->id + "." + format);
      if (args.what == "both") write(core_mesh(block->body), block->id + "_core." + format);
    }
  }
  std::cout << args.folder << ": " << counted(written, "file") << " of "
            << counted(blocks.size(), "block") << " written\n";
}

}  // namespace

void add_export(CLI::App& app) {
  const auto args = std::make_shared<ExportArgs>();
  CLI::App* command = app.add_subcommand("export", "Hand blocks to other tools");
  command->add_option("library", args->library, "Block library")->required()->type_name("LIB");
  command->add_option("ids", args->ids, "Blocks to export; without: all")->type_name("ID");
  command
      ->add_option("-o,--output", args->folder, "Folder, made when missing; a file for each block")
      ->type_name("DIR")
      ->capture_default_str();
  command
      ->add_option("--format", args->formats,
                   "Comma-separated: shp (Rockable, ExaDEM), obj, stl, ply, glb, vtp")
      ->type_name("LIST")
      ->capture_default_str();
  command
      ->add_option("--what", args->what,
                   "Surface in mesh files: the rounded skin, the core, or both (a second file "
                   "ID_core)")
      ->check(CLI::IsMember({"skin", "core", "both"}))
      ->type_name("NAME")
      ->capture_default_str();
  command->add_option("--up", args->up, "Up axis of mesh files: z as stored, or y")
      ->check(up_axis())
      ->type_name("AXIS")
      ->capture_default_str();
  command->footer(
      "Mesh files are in metres, in the frame of the scan. shp files hold core and "
      "radius in the principal\nframe, origin at the centre of mass.\n"
      "Example:\n  clast export blocks.h5 SP1A SP3A -o shapes --format shp,stl");
  command->callback([args] { export_blocks(*args); });
}

}  // namespace clast
