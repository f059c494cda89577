#pragma once
/// Blocks from field scans: removes ground, closes undersides, and bounds the unobserved parts.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/pose.hpp"
#include "core/progress.hpp"
#include "reconstruct/cloud/cloud_surface.hpp"
#include "reconstruct/deposit/deposit.hpp"
#include "reconstruct/ground/ground.hpp"
#include "reconstruct/scan.hpp"
#include "reconstruct/underside/underside.hpp"
#include "shapes/volume_bracket.hpp"

namespace clast {

struct FieldScanOptions {
  ScanOptions scan;  ///< unit, up axis and repair options
  bool up_given =
      false;  ///< true if `scan.up` was given; otherwise, z points up from a detected ground
  bool find_ground = true;  ///< false if the scan contains a single block without ground
  bool split = false;  ///< true: extracts all blocks of a deposit; false: the one near the centre
  double smallest_axis = 0.0;           ///< with `split`: least intermediate axis I of a block, m
  std::vector<DepositEdit> edits = {};  ///< with `split`: corrections of the segmentation
  /// Positions of the scanner or the cameras, in units and axes of the scan, for `split`. Empty if
  /// they are unknown.
  std::vector<Vec3> stations = {};
  CloudSurfaceOptions surface = {};  ///< surface reconstruction from points
  /// Observed free space in file coordinates; null if unknown.
  const FreeSpaceGrid* free_space = nullptr;
  ProgressCallback progress = {};  ///< called with the name of each step before it starts

  void check() const;  ///< throws what its members throw
};

struct FieldBlock {
  Scan scan;                           ///< closed mesh with repairs, in metres, z up
  std::optional<Underside> underside;  ///< for an open scan, in the frame of `scan`
  std::optional<VolumeBracket>
      bounds;  ///< bounds of the volume; empty if the scan is practically closed
  /// Visible part of a block of a deposit; `points` are indices of points as read. Its body and its
  /// bounds are moved to `scan` and `bounds`. Empty for a block that was not split off a deposit.
  std::optional<DepositBlock> in_deposit = {};
  /// Transform from file coordinates in metres, z up, to the frame of `scan`.
  Pose block_from_file = {Vec3::Zero(), Quat::Identity()};
};

/// All blocks of a deposit, at their places in the file, in metres, z up.
struct FieldDeposit {
  std::vector<FieldBlock> blocks = {};     ///< ordered by x, then y
  std::vector<LeftOutPart> left_out = {};  ///< parts that may be blocks but are not among them
  std::vector<std::string> notes = {};     ///< notes on the whole scan
  /// Block of each point as read, from 1; 0: ground, fines or left out.
  std::vector<std::uint32_t> block_of_point = {};
  double spacing = 0.0;  ///< spacing of the points as read, m; 0 if the scan is one closed body
};

/// A scan as read and its blocks. Without `split`, there is one block and nothing else.
struct FieldScan : FieldDeposit {
  TriangleMesh raw;  ///< mesh as read, in the file's units and axes; without triangles for a cloud
  std::string crs;   ///< reference system that the file states; empty if unknown
};

/// A mesh or cloud as read, without its blocks.
struct RawScan {
  TriangleMesh mesh;  ///< in the file's units and axes; without triangles for a cloud
  ScanOptions scan;   ///< options with the up axis of the file
  /// Pass in which each point was recorded (`number_passes`); empty if there is only one.
  std::vector<std::uint32_t> passes = {};
  std::string crs;                 ///< reference system that the file states; empty if unknown
  std::vector<std::string> notes;  ///< on coordinates and points left out
};

/// Reads a mesh or cloud, and checks that its coordinates are lengths in the stated unit.
/// @throws InputError  if `read_mesh` or `stream_cloud` throws, or if the file stores too few
///                     digits for the shape of the block
RawScan read_raw_scan(const std::filesystem::path& path, const ScanOptions& options = {});

/// Reads a mesh or cloud and extracts its blocks, at least one. Closed meshes are cleaned as by
/// `read_scan`. In open meshes, the ground is removed and the underside is closed. For clouds, a
/// surface is reconstructed first. With `split`, `extract_deposit_blocks` extracts all blocks.
/// @throws InputError  if `read_mesh` or `stream_cloud` throws, if a cloud has too few points, or
///                     if the file stores too few digits for the shape of the block
/// @throws GeometryError  if there is only ground, or if `clean_scan` or `close_underside` throws
FieldScan read_field_scan(const std::filesystem::path& path, const FieldScanOptions& options = {});

/// Extracts the blocks of a mesh or cloud in memory. Messages refer to it as `name`.
std::vector<FieldBlock> extract_field_blocks(const TriangleMesh& raw, const std::string& name,
                                             const FieldScanOptions& options = {});
std::vector<FieldBlock> extract_field_blocks(const std::vector<Vec3>& points,
                                             const std::string& name,
                                             const FieldScanOptions& options = {});

/// Extracts all blocks of a deposit, apart or touching, in metres, z up, at their places in the
/// file. A mesh that is a closed body is one block.
/// @throws InputError  if a point is out of range, or there are too few points
/// @throws GeometryError  if no part of the scan is a block
FieldDeposit extract_deposit_blocks(const std::vector<Vec3>& points, const std::string& name,
                                    const FieldScanOptions& options = {});
FieldDeposit extract_deposit_blocks(const TriangleMesh& raw, const std::string& name,
                                    const FieldScanOptions& options = {});

}  // namespace clast
