#pragma once
/// Export of blocks as meshes, and as .shp files for Rockable and ExaDEM.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "library/block.hpp"
#include "shapes/shp_file.hpp"

namespace clast {

enum class ExportedSurface {
  kSkin,     ///< rounded surface
  kCore,     ///< core polyhedron
  kBoth,     ///< both; the core is written to a second file ID_core
  kSurface,  ///< simplified scan from which the block was made
};

enum class ExportFrame {
  kSource,     ///< frame of the scan
  kPrincipal,  ///< origin at the centre of mass, axes along the principal axes, as in .shp files
};

struct BlockExportOptions {
  std::vector<std::string> formats = {"shp"};  ///< names of `block_export_formats`
  ExportedSurface surface = ExportedSurface::kSkin;
  ExportFrame frame = ExportFrame::kSource;
  /// Up axis of meshes in the source frame: "z", "y" or "auto". "y" rotates (x, y, z) to (x, z,
  /// -y). "auto" is y for .glb, as in glTF, and z for other formats.
  std::string up = "auto";
  std::optional<int> segments =
      {};  ///< number of segments per quarter turn of the rounded surface, 1 to 64; default 4
  bool replace = false;  ///< if false, existing files are an error, and none is written

  bool includes_rounded_surface() const;  ///< true if a rounded surface is written
  void check() const;                     ///< throws InputError naming the field and its value
};

/// Converts a block to a .shp shape in the principal frame. Coplanar faces are merged to polygons.
ShpShape to_shp_shape(const Block& block);

/// Returns the names of the formats: "shp", "obj", "stl", "ply", "glb", "vtp".
const std::vector<std::string>& block_export_formats();

/// Writes one file per block and format to a folder. The folder is created if it is missing.
/// @param note  called with warnings on unscaled blocks, ineffective segments, and coordinates too
///              far from the origin for floats
/// @return the files in the order of writing
/// @throws InputError  if `BlockExportOptions::check` throws, there is no block, a file exists, or
///                     a file cannot be written
/// @throws GeometryError  if the core of a ball or capsule is requested, which is not a mesh
std::vector<std::filesystem::path> export_blocks(
    const std::vector<const Block*>& blocks, const std::filesystem::path& folder,
    const BlockExportOptions& options = {},
    const std::function<void(const std::string& text)>& note = {});

}  // namespace clast
