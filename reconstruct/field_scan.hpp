#pragma once
/// Blocks out of field scans: ground removed, underside closed, and what is left open bounded.
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

/// How a field scan is divided into blocks.
struct FieldScanOptions {
  ScanOptions scan;
  bool up_given = false;  ///< `scan.up` holds; else z points up from the ground where one is found
  bool find_ground = true;           ///< false: the scan is of one block alone
  bool split = false;                ///< every block on the ground; else the one near the middle
  CloudSurfaceOptions surface = {};  ///< how points become one
  /// Space that was looked through, in the file's coordinates; none: nothing is known of that.
  const FreeSpaceGrid* free_space = nullptr;

  void check() const;  ///< throws what its members throw
};

/// One block of a scan.
struct FieldBlock {
  Scan scan;                            ///< closed, in metres, z up
  std::optional<Underside> underside;   ///< of a scan that was open; in the frame of `scan`
  std::optional<VolumeBracket> bounds;  ///< none: nothing to speak of is left open
  /// To the frame of `scan` from the file's coordinates in metres, z up.
  Pose block_from_file = {Vec3::Zero(), Quat::Identity()};
};

/// A file and the blocks it gave.
struct FieldScan {
  TriangleMesh raw;  ///< as read, in the file's units and axes; of a cloud the points alone
  std::vector<FieldBlock> blocks;
};

/// The blocks of a mesh or cloud, at least one. A closed mesh is cleaned as `read_scan` does. Of an
/// open one the ground is removed and the underside closed. Points become a surface first.
/// With `split` the blocks come in order of x, then y, of the file; without, there is one.
/// @throws InputError     what `read_mesh` and `stream_cloud` throw; a cloud of too few points;
///                        coordinates that lost the block's shape because the file keeps too few
///                        digits of them
/// @throws GeometryError  only ground, and what `clean_scan` and `close_underside` throw
FieldScan read_field_scan(const std::filesystem::path& path, const FieldScanOptions& options = {});

/// The same of a mesh or of points in memory; `name` is used in messages.
std::vector<FieldBlock> extract_field_blocks(const TriangleMesh& raw, const std::string& name,
                                     const FieldScanOptions& options = {});
std::vector<FieldBlock> extract_field_blocks(const std::vector<Vec3>& points, const std::string& name,
                                     const FieldScanOptions& options = {});

}  // namespace clast
