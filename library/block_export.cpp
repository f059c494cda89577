#include "library/block_export.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/output_file.hpp"
#include "core/files/up_axis.hpp"
#include "core/number_text.hpp"
#include "library/unscaled.hpp"
#include "mesh/mesh_io.hpp"
#include "shapes/coplanar_faces.hpp"
#include "shapes/outer_surface.hpp"

namespace clast {

namespace {

constexpr int kUsualSegments = 4, kMaxExportSegments = 64;

/// A mesh of a block, and what its file has after the id.
struct NamedMesh {
  std::string suffix;
  TriangleMesh mesh;
};

std::vector<std::string> suffixes(const BlockExportOptions& options, const std::string& format) {
  const bool two = options.surface == ExportedSurface::kBoth && format != "shp";
  return two ? std::vector<std::string>{"", "_core"} : std::vector<std::string>{""};
}

std::vector<NamedMesh> meshes_of(const Block& block, const BlockExportOptions& options) {
  std::vector<NamedMesh> meshes;
  if (options.surface == ExportedSurface::kSurface) {
    meshes.push_back({"", block.surface});
  } else if (options.surface != ExportedSurface::kSkin && block.body.faces.empty()) {
    throw GeometryError("block " + block.id +
                        " is a ball or a capsule, whose core is no mesh; use `what` skin");
  } else {
    if (options.includes_rounded_surface())
      meshes.push_back(
          {"", outer_surface_mesh(block.body, options.segments.value_or(kUsualSegments))});
    const bool both = options.surface == ExportedSurface::kBoth;
    if (options.surface == ExportedSurface::kCore || both) {
      meshes.push_back({both ? "_core" : "", core_mesh(block.body)});
    }
  }
  if (options.frame == ExportFrame::kPrincipal) {
    const Pose principal_from_source = block.source_from_body().inverse();
    for (NamedMesh& named : meshes) {
      named.mesh = transformed(std::move(named.mesh), principal_from_source);
    }
  }
  return meshes;
}

/// The mesh as a file of that name has it.
TriangleMesh upright(TriangleMesh mesh, const std::filesystem::path& file,
                     const BlockExportOptions& options) {
  if (options.frame == ExportFrame::kPrincipal || resolve_up_axis(options.up, file) == "z")
    return mesh;
  for (Vec3& vertex : mesh.vertices) vertex = z_up_to_y_up(vertex);
  return mesh;
}

std::filesystem::path file_of(const std::filesystem::path& folder, const Block& block,
                              const std::string& suffix, const std::string& format) {
  return folder / (block.id + suffix + "." + format);
}

OverwritePolicy rules_of(const std::filesystem::path& file, const BlockExportOptions& options) {
  return {.kind = file_kind_by_extension(file), .replace = options.replace};
}

/// Checks that no file to be written would replace another, such as the scan of the block.
void check_places(const std::vector<const Block*>& blocks, const std::filesystem::path& folder,
                  const BlockExportOptions& options) {
  for (const Block* block : blocks) {
    for (const std::string& format : options.formats) {
      for (const std::string& suffix : suffixes(options, format)) {
        const std::filesystem::path file = file_of(folder, *block, suffix, format);
        check_mesh_output(file, rules_of(file, options));
      }
    }
  }
}

/// Notes on a block before its files are written.
std::vector<std::string> notes_on(const Block& block, const BlockExportOptions& options) {
  std::vector<std::string> notes;
  if (is_unscaled(block)) {
    notes.push_back("block " + block.id + " is unscaled, so its exported coordinates are not in " +
                    "metres: " + explain_unscaled_block());
  }
  if (!options.includes_rounded_surface() || !options.segments) return notes;
  const std::optional<double> length = outer_surface_edge_length(block.body, *options.segments);
  const int most = max_outer_surface_segments(block.body);
  if (length && *options.segments > most) {
    notes.push_back("block " + block.id + " is concave: its skin is wrapped in triangles of " +
                    format_significant(*length, 3) + (is_unscaled(block) ? " units" : " m") +
                    ", the shortest allowed (1/150 of its diagonal), so `segments` " +
                    std::to_string(*options.segments) + " gives the same skin as " +
                    std::to_string(most));
  }
  return notes;
}

}  // namespace

ShpShape to_shp_shape(const Block& block) {
  ShpShape shape;
  shape.name = block.id;
  std::replace_if(
      shape.name.begin(), shape.name.end(), [](char c) { return c == ' '; }, '_');
  shape.source_from_body = block.source_from_body();
  const Pose body_from_source = shape.source_from_body.inverse();
  shape.body =
      transformed(merge_coplanar_faces(block.body, kFileFlatnessTolerance), body_from_source);
  shape.volume = block.mass.volume;
  shape.inertia_per_mass = block.principal.moments / block.mass.mass;
  shape.box = block.box;
  shape.box.centre = body_from_source * block.box.centre;
  shape.box.axes = body_from_source.rotation.toRotationMatrix() * block.box.axes;
  return shape;
}

const std::vector<std::string>& block_export_formats() {
  static const std::vector<std::string> kFormats = {"shp", "obj", "stl", "ply", "glb", "vtp"};
  return kFormats;
}

bool BlockExportOptions::includes_rounded_surface() const {
  const bool meshes = std::any_of(formats.begin(), formats.end(),
                                  [](const std::string& format) { return format != "shp"; });
  return meshes && (surface == ExportedSurface::kSkin || surface == ExportedSurface::kBoth);
}

void BlockExportOptions::check() const {
  if (formats.empty()) throw InputError("`format` is empty");
  for (const std::string& format : formats) {
    const std::vector<std::string>& known = block_export_formats();
    if (std::find(known.begin(), known.end(), format) != known.end()) continue;
    throw InputError("`format`: \"" + format +
                     "\" is not known; expected shp, obj, stl, ply, glb or vtp");
  }
  if (segments && (*segments < 1 || *segments > kMaxExportSegments)) {
    throw InputError("`segments` = " + std::to_string(*segments) + ": must be from 1 to " +
                     std::to_string(kMaxExportSegments));
  }
  resolve_up_axis(up, {});
  if (frame == ExportFrame::kPrincipal && up == "y") {
    throw InputError(
        "`up` y applies to the source frame only; the principal frame has no upward axis");
  }
}

std::vector<std::filesystem::path> export_blocks(
    const std::vector<const Block*>& blocks, const std::filesystem::path& folder,
    const BlockExportOptions& options, const std::function<void(const std::string& text)>& note) {
  options.check();
  if (blocks.empty()) throw InputError("there is no block to export");
  check_places(blocks, folder, options);
  const auto report = [&](const std::string& text) {
    if (note) note(text);
  };
  std::vector<std::filesystem::path> written;
  for (const Block* block : blocks) {
    for (const std::string& text : notes_on(*block, options)) report(text);
    std::vector<NamedMesh> meshes;
    if (options.formats != std::vector<std::string>{"shp"}) meshes = meshes_of(*block, options);
    for (const std::string& format : options.formats) {
      if (format == "shp") {
        const ShpShape shape = to_shp_shape(*block);
        written.push_back(file_of(folder, *block, "", format));
        write_shp(written.back(), {&shape, 1}, rules_of(written.back(), options));
        continue;
      }
      for (const NamedMesh& named : meshes) {
        const std::filesystem::path file = file_of(folder, *block, named.suffix, format);
        const Vec3 origin = write_mesh(file, upright(named.mesh, file, options),
                                       {.rules = rules_of(file, options)});
        written.push_back(file);
        if (origin.isZero(0.0)) continue;
        report(file.string() + ": its floats can't hold coordinates this far out, so " +
               format_point(origin) + " was subtracted (see " + file.filename().string() +
               ".origin.txt); obj, ply and vtp keep them");
      }
    }
  }
  return written;
}

}  // namespace clast
