#pragma once
/// Extraction of blocks from point clouds.
#include <cstdint>
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// Points of a cloud without duplicates and outliers.
struct CleanCloud {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> sources;  ///< index of each point in the cloud as read
  /// Index of the first point with the same coordinates, one per point as read.
  std::vector<std::uint32_t> first_duplicates;
  std::vector<std::string> notes;
};

/// Removes duplicates and outliers.
/// @param unit  metres per unit of the points
/// @throws InputError  if a point is out of range, or there are too few points
CleanCloud clean_cloud(const std::vector<Vec3>& raw, const std::string& name, double unit);

/// Extracts the blocks of a cloud. Removes duplicates, outliers, far points and, if present, the
/// ground. Closes each block.
/// @param name  name of the scan, for messages
/// @throws InputError  if a point is out of range, or there are too few points
/// @throws GeometryError  if there are separate clusters but no ground, if there is only ground, or
///                        if `close_block` throws
std::vector<FieldBlock> extract_cloud_blocks(const std::vector<Vec3>& raw, const std::string& name,
                                             const FieldScanOptions& options);

}  // namespace clast::reconstruct_detail
