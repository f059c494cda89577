#pragma once
/// The whole way from one scan to its blocks.
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/progress.hpp"
#include "library/make_block.hpp"
#include "reconstruct/field_scan.hpp"
#include "reconstruct/photos/photo_scan.hpp"
#include "reconstruct/simplify.hpp"

namespace clast {

/// Options of every step.
struct ScanToBlockOptions {
  ScanOptions scan;
  std::string units = "m";  ///< as the user wrote it, for messages and the record
  /// The two points whose distance gave the unit, in the scan's own units and axes.
  std::optional<std::array<Vec3, 2>> scale_points;
  double scale_factor = 1.0;  ///< what `scan.unit` holds beside the unit itself
  /// Vertices a block has at most, not used for a core. None: the fewest of 8 to 2000, to about a
  /// tenth, with which the block is within the tolerance; the radius is halved where none will do.
  std::optional<std::size_t> vertices;
  BlockOptions block;
  bool radius_given = false;    ///< the radius, or its share of S, is the user's and stays
  bool allow_any_size = false;  ///< take blocks beyond the usual sizes
  bool up_given = false;        ///< `scan.up` is the user's and holds whatever the ground says
  bool find_ground = true;
  bool split = false;       ///< every block that stands on the ground of a scan
  PhotoScanOptions photos;  ///< of folders of photographs

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const ScanToBlockOptions& options, Visit&& visit) {
  const auto& [scan, units, scale_points, scale_factor, vertices, block, radius_given, any_size,
               up_given, find_ground, split, photos] = options;
  visit("scan", scan);
  visit("units", units);
  visit("scale_points", scale_points);
  visit("scale_factor", scale_factor);
  visit("vertices", vertices);
  visit("block", block);
  visit("radius_given", radius_given);
  visit("any_size", ExcludedField{any_size});
  visit("up_given", up_given);
  visit("find_ground", find_ground);
  visit("split", split);
  visit("photos", photos);
}

/// What a block was made from, while that is in memory.
struct BlockOrigin {
  /// As read, in the file's units and axes; of a cloud the points alone. Null for a .shp shape.
  const TriangleMesh* raw = nullptr;
  const FieldBlock* field_block =
      nullptr;                        ///< the closed scan, in the frame of the block; null as `raw`
  const PhotoScan* photos = nullptr;  ///< of a folder of photographs, else null
  std::string up = "z";               ///< axis of the file that points up
};

/// What follows a scan on its way; each may be empty.
struct ScanCallbacks {
  ProgressCallback progress = {};  ///< with the name of each step before it begins
  std::function<void(const Block& block, const BlockOrigin& origin)> on_block_made = {};
  /// With it one bad block of a split scan does not cost the others.
  std::function<void(const std::string& id, const std::string& reason)> on_block_lost = {};

  void begin_step(const std::string& what, bool is_slow = false) const {
    if (progress) progress({.activity = what, .is_slow = is_slow});
  }
};

/// SHA-256 of a file, or of the photographs in a folder.
/// @throws InputError  it can't be read
std::string scan_digest(const std::filesystem::path& path);

/// Reads, repairs, simplifies and measures one scan: a mesh, a cloud or a folder of photographs.
/// With `split` its blocks are `id`_1, `id`_2, ..., in order of x, then y, of the file; else there
/// is one, `id`.
/// @throws InputError, GeometryError  with the file or the id in the message; also for a size that
///         no rock block has
std::vector<Block> reconstruct_blocks(const std::filesystem::path& path, const std::string& id,
                                      const ScanToBlockOptions& options = {},
                                      const ScanCallbacks& callbacks = {});

/// The same of a mesh in memory, or of points where it has no triangles. The record names `id` as
/// its source, and the digest is that of the numbers.
/// @throws InputError, GeometryError  as for a file
std::vector<Block> reconstruct_mesh_blocks(const TriangleMesh& raw, const std::string& id,
                                           const ScanToBlockOptions& options = {},
                                           const ScanCallbacks& callbacks = {});

}  // namespace clast
