#pragma once
/// One block from several scans of it.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"
#include "reconstruct/registration/joined_surface.hpp"

namespace clast {

/// One of several scans of a block.
struct ScanToJoin {
  std::string name;  ///< for messages
  TriangleMesh raw;  ///< as read; without triangles for a cloud
  ScanOptions scan;  ///< unit and up axis
};

/// A block and the scans that were joined.
struct JoinedScan {
  FieldBlock block;           ///< in the frame of the first scan, m, z up
  Registration registration;  ///< in metres, z up
  std::vector<JoinedPoints> scans;
  /// Mean distance of the surfaces of the scans at each vertex of the block, m; NaN where one scan
  /// alone observed it.
  std::vector<double> distances;
};

/// Separates the block of each scan from its ground, registers the scans, and reconstructs one
/// surface from the points of all.
/// @param name  name of the block, for messages
/// @param options  its `scan` is not used
/// @throws InputError, GeometryError  if a scan has no block, or if `register_scans` or the
///                                    reconstruction throws
JoinedScan join_scans(const std::vector<ScanToJoin>& scans, const std::string& name,
                      const FieldScanOptions& options, const RegistrationOptions& registration);

/// Divides a scan into passes that do not fit, registers them, and reconstructs one surface from
/// the points of all. The block keeps its position in the scan, and its ground.
/// @param passes  pass of each vertex of `scan.raw`, such as the flight strip; if empty, passes
///                are the parts that show the same surface at two places
/// @param options  its `scan` is not used
/// @return  empty if fewer than two passes show enough of the block
/// @throws InputError, GeometryError  if the scan has no block, if passes do not fit, or if the
///                                    reconstruction throws
std::optional<JoinedScan> align_passes(const ScanToJoin& scan,
                                       const std::vector<std::uint32_t>& passes,
                                       const std::string& name, const FieldScanOptions& options,
                                       const RegistrationOptions& registration);

}  // namespace clast
