#pragma once
/// Export of blocks: .shp for Rockable and ExaDEM, and meshes.
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
  kBoth,     ///< both, the core in a second file ID_core
  kSurface,  ///< simplified scan from which the block was made
};

enum class ExportFrame {
  kSource,     ///< frame of the scan
  kPrincipal,  ///< origin at the centre of mass, axes along the principal axes, as in .shp files
};

struct BlockExportOptions {
  std::vector<std::string> formats = {"shp"};  ///< of `block_export_formats`
  ExportedSurface what = ExportedSurface::kSkin;
  ExportFrame frame = ExportFrame::kSource;
  /// Up axis of meshes in the source frame: "z"; "y", which rotates (x, y, z) to (x, z, -y); or
  /// "auto", y for .glb as in glTF and z for others.
  std::string up = "auto";
  std::optional<int> segments =
      {};  ///< per quarter turn of the rounded surface, 1 to 64; default 4
  bool replace =
      false;  ///< replace existing files; false: they are an error, before anything is written

  bool includes_rounded_surface() const;  ///< is a rounded surface written?
  void check() const;                     ///< throws InputError naming the field and its value
};

/// Converts a block to a .shp shape: principal frame, coplanar faces merged to polygons.
ShpShape to_shp_shape(const Block& block);

/// Returns the formats: "shp", "obj", "stl", "ply", "glb", "vtp".
const std::vector<std::string>& block_export_formats();

/// Writes one file per block and format to a folder, which is created if missing.
/// @param note  receives warnings: unscaled blocks, ineffective segments, coordinates too far from
///              the origin for floats
/// @return the files in writing order
/// @throws InputError  as `BlockExportOptions::check`; if there is no block, a file exists; or as
///                     `OutputFile`
/// @throws GeometryError  for the core of a ball or capsule, which is not a mesh
std::vector<std::filesystem::path> export_blocks(
    const std::vector<const Block*>& blocks, const std::filesystem::path& folder,
    const BlockExportOptions& options = {},
    const std::function<void(const std::string& text)>& note = {});

}  // namespace clast
