#pragma once
/// Extraction of blocks from point clouds.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// Removes duplicates, outliers, far points and, if present, the ground, and closes each block.
/// @param name  of the scan, for messages
/// @throws InputError  if a point is out of range, or there are too few
/// @throws GeometryError  for separate clusters without ground, or only ground; and as
///                        `close_block`
std::vector<FieldBlock> extract_cloud_blocks(const std::vector<Vec3>& raw, const std::string& name,
                                             const FieldScanOptions& options);

}  // namespace clast::reconstruct_detail
