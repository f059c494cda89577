#pragma once
/// Blocks to files for other tools: .shp for Rockable and ExaDEM, and meshes.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "library/block.hpp"
#include "shapes/shp_file.hpp"

namespace clast {

/// What a mesh file holds of a block.
enum class ExportedSurface {
  kSkin,     ///< the rounded surface
  kCore,     ///< the polyhedron inside it
  kBoth,     ///< both, the core in a second file ID_core
  kSurface,  ///< the simplified scan that the block was made from
};

enum class ExportFrame {
  kSource,     ///< of the scan
  kPrincipal,  ///< origin at the centre of mass, axes along the principal ones, as in .shp files
};

struct BlockExportOptions {
  std::vector<std::string> formats = {"shp"};  ///< of `block_export_formats`
  ExportedSurface what = ExportedSurface::kSkin;
  ExportFrame frame = ExportFrame::kSource;
  /// Of meshes in the source frame: "z"; "y", which turns (x, y, z) to (x, z, -y); or "auto", y in
  /// .glb, as glTF has it, and z in all others.
  std::string up = "auto";
  std::optional<int> segments = {};  ///< of a quarter turn in the skin, 1 to 64; absent: 4
  bool replace = false;  ///< existing files; else they are refused before anything is written

  bool includes_rounded_surface() const;  ///< is a rounded surface written?
  void check() const;       ///< throws InputError naming the field and its value
};

/// A block as a .shp file has it: in the principal frame, its faces in one plane as one polygon.
ShpShape to_shp_shape(const Block& block);

/// "shp", "obj", "stl", "ply", "glb", "vtp".
const std::vector<std::string>& block_export_formats();

/// Writes a file per block and format to the folder, which is made if missing.
/// @param note  gets what a user should know: unscaled blocks, more segments than have an effect,
///              coordinates too far out for floats
/// @return the files, in the order in which they were written
/// @throws InputError     a field as `BlockExportOptions::check`; no block; a file that is there
///                        already; or as `OutputFile`
/// @throws GeometryError  the core of a ball or a capsule, which is no mesh
std::vector<std::filesystem::path> export_blocks(
    const std::vector<const Block*>& blocks, const std::filesystem::path& folder,
    const BlockExportOptions& options = {},
    const std::function<void(const std::string& text)>& note = {});

}  // namespace clast
