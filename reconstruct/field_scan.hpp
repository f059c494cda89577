#pragma once
/// Blocks from field scans: ground removed, underside closed, uncertainty bounded.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/pose.hpp"
#include "reconstruct/cloud/cloud_surface.hpp"
#include "reconstruct/ground/ground.hpp"
#include "reconstruct/scan.hpp"
#include "reconstruct/underside/underside.hpp"
#include "shapes/volume_bracket.hpp"

namespace clast {

struct FieldScanOptions {
  ScanOptions scan;         ///< closed, metres, z up
  bool up_given = false;    ///< `scan.up` was given; otherwise z points up from a detected ground
  bool find_ground = true;  ///< false: the scan is of a single block
  bool split = false;       ///< all blocks above the ground; otherwise the one near the centre
  CloudSurfaceOptions surface = {};  ///< surface reconstruction from points
  /// Free space in file coordinates; null if unknown.
  const FreeSpaceGrid* free_space = nullptr;

  void check() const;  ///< throws what its members throw
};

struct FieldBlock {
  Scan scan;                            ///< closed, in metres, z up
  std::optional<Underside> underside;   ///< of an open scan, in the frame of `scan`
  std::optional<VolumeBracket> bounds;  ///< empty if the scan is practically closed
  /// Transform from file coordinates in metres, z up, to the frame of `scan`.
  Pose block_from_file = {Vec3::Zero(), Quat::Identity()};
};

struct FieldScan {
  TriangleMesh raw;  ///< as read, in the file's units and axes; points only for a cloud
  std::vector<FieldBlock> blocks;
};

/// Reads a mesh or cloud and extracts its blocks, at least one. Closed meshes are cleaned as by
/// `read_scan`; in open ones the ground is removed and the underside closed; points become a
/// surface first. With `split`, blocks are ordered by x, then y of the file; otherwise there is
/// one.
/// @throws InputError  as `read_mesh` and `stream_cloud`; if a cloud has too few points, or too few
///                     stored digits have lost the block's shape
/// @throws GeometryError  for only ground; and as `clean_scan` and `close_underside`
FieldScan read_field_scan(const std::filesystem::path& path, const FieldScanOptions& options = {});

/// Extracts the blocks of a mesh or points in memory; `name` is used in messages.
std::vector<FieldBlock> extract_field_blocks(const TriangleMesh& raw, const std::string& name,
                                             const FieldScanOptions& options = {});
std::vector<FieldBlock> extract_field_blocks(const std::vector<Vec3>& points,
                                             const std::string& name,
                                             const FieldScanOptions& options = {});

}  // namespace clast
