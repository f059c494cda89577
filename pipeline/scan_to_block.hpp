#pragma once
/// Processing of a scan into blocks.
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/fields.hpp"
#include "core/progress.hpp"
#include "library/make_block.hpp"
#include "pipeline/join_options.hpp"
#include "reconstruct/field_scan.hpp"
#include "reconstruct/joined_scan.hpp"
#include "reconstruct/photos/photo_scan.hpp"
#include "reconstruct/simplify.hpp"

namespace clast {

struct ScanToBlockOptions {
  ScanOptions scan;
  std::string units =
      "m";  ///< length unit as given by the user, for messages and `BlockSource::options`
  /// Two points whose distance determined the scale, in units and axes of the scan.
  std::optional<std::array<Vec3, 2>> scale_points;
  double scale_factor = 1.0;  ///< factor that `scan.unit` includes in addition to the unit
  /// Maximum number of vertices; not used for a core. If empty, the smallest number from 8 to 2000
  /// that is within tolerance is searched (`FewestVerticesSearch`).
  std::optional<std::size_t> vertices;
  BlockOptions block;
  bool radius_given =
      false;  ///< true if the user gave the radius or its ratio to S; it is then not changed
  bool allow_any_size = false;  ///< true: blocks of unusual size are accepted
  bool up_given = false;  ///< true if the user gave `scan.up`, which overrides detected ground
  bool find_ground = true;
  bool split = false;                   ///< true: makes all blocks of a deposit
  double smallest_axis = 0.0;           ///< with `split`: least intermediate axis I of a block, m
  std::vector<DepositEdit> edits = {};  ///< with `split`: corrections of the segmentation
  /// Positions of the scanner or the cameras, in units and axes of the scan, for `split`. Empty if
  /// they are unknown; for photographs, those of the cameras are used.
  std::vector<Vec3> stations = {};
  /// PLY file to which the points of a split scan are written with the block of each
  /// (`write_labelled_cloud`); empty: none is written.
  std::filesystem::path labelled = {};
  PhotoScanOptions photos;  ///< options for folders of photographs
  JoinOptions join = {};    ///< for scans that are joined to one block
  bool align = false;       ///< true: registers passes of one scan that do not fit

  void check() const;  ///< throws InputError naming the field and its value
};

template <class Visit>
void visit_fields(const ScanToBlockOptions& options, Visit&& visit) {
  const auto& [scan, units, scale_points, scale_factor, vertices, block, radius_given, any_size,
               up_given, find_ground, split, smallest_axis, edits, stations, labelled, photos, join,
               align] = options;
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
  visit("smallest_axis", smallest_axis);
  visit("edits", edits);
  visit("stations", stations);
  visit("labelled", ExcludedField{labelled});
  visit("photos", photos);
  visit("join", join);
  visit("align", align);
}

/// Scan data from which a block was made.
struct BlockOrigin {
  /// Mesh as read, in units and axes of the file. A cloud has no triangles; null for .shp.
  const TriangleMesh* raw = nullptr;
  const FieldBlock* field_block =
      nullptr;  ///< closed scan in the block frame; null for a .shp shape
  const PhotoScan* photos =
      nullptr;           ///< photo scan; null if the source is not a folder of photographs
  std::string up = "z";  ///< up axis of the file
  const JoinedScan* joined =
      nullptr;  ///< joined scans, of which `raw` has the points; null for one
};

/// Points of a split scan and the blocks that were made of them.
struct DepositOrigin {
  const FieldScan* scan = nullptr;  ///< points, block of each point, and parts left out
  double unit = 1.0;                ///< metres per unit of the points
  std::string up = "z";             ///< up axis of the points
  /// Ids of the blocks in the order of `FieldDeposit::block_of_point`, also of failed ones.
  std::vector<std::string> ids;
};

/// Callbacks during the processing of a scan. All are optional.
struct ScanCallbacks {
  ProgressCallback progress = {};  ///< called with the name of each step before it starts
  std::function<void(const Block& block, const BlockOrigin& origin)> on_block_made = {};
  /// Called when all blocks of a split scan are made, unless it is one closed body.
  std::function<void(const std::vector<Block>& blocks, const DepositOrigin& origin)>
      on_deposit_made = {};
  std::function<void(const std::string& note)> on_note = {};  ///< called with notes on the scan
  /// Returns whether a block of a split scan is not needed, because it was made earlier.
  std::function<bool(const std::string& id)> is_known = {};
  /// Called for a failed block of a split scan. If it is set, the other blocks are still made.
  std::function<void(const std::string& id, const std::string& reason)> on_block_lost = {};

  void begin_step(const std::string& what, bool is_slow = false) const {
    if (progress) progress({.activity = what, .is_slow = is_slow});
  }
};

/// Returns the SHA-256 of a file, or of the photographs in a folder.
/// @throws InputError  if the file or a photograph cannot be read
std::string compute_scan_digest(const std::filesystem::path& path);

/// Makes the blocks of a scan: reads, repairs, simplifies and measures it. The scan is a mesh, a
/// cloud or a folder of photographs. With `split`, the blocks are `id`_1, `id`_2, ..., ordered by
/// x, then y of the file, without those that are known (`ScanCallbacks::is_known`); otherwise,
/// there is one block, `id`.
/// @throws InputError, GeometryError  if a step fails or a size is implausible; names the file or
///                                    the id
std::vector<Block> reconstruct_blocks(const std::filesystem::path& path, const std::string& id,
                                      const ScanToBlockOptions& options = {},
                                      const ScanCallbacks& callbacks = {});

/// Returns the SHA-256 of the digests of several scans.
std::string compute_joined_digest(const std::vector<std::filesystem::path>& paths);

/// Makes one block of several scans of it: meshes, clouds and folders of photographs, in any poses.
/// The block is in the frame of the first scan, in metres, z up.
/// @throws InputError, GeometryError  if a step fails, if the scans do not fit, or if they fit in
///                                    several ways
Block reconstruct_joined_block(const std::vector<std::filesystem::path>& paths,
                               const std::string& id, const ScanToBlockOptions& options = {},
                               const ScanCallbacks& callbacks = {});

/// Makes the blocks of a mesh in memory, or of a cloud if it has no triangles. The source of the
/// blocks is `id` with the digest of the coordinates.
/// @throws InputError, GeometryError  if `reconstruct_blocks` would throw
std::vector<Block> reconstruct_mesh_blocks(const TriangleMesh& raw, const std::string& id,
                                           const ScanToBlockOptions& options = {},
                                           const ScanCallbacks& callbacks = {});

}  // namespace clast
