#pragma once
/// Extraction of blocks from point clouds.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// Extracts the blocks of a cloud. Removes duplicates, outliers, far points and, if present, the
/// ground. Closes each block.
/// @param name  name of the scan, for messages
/// @throws InputError  if a point is out of range, or there are too few points
/// @throws GeometryError  if there are separate clusters but no ground, if there is only ground, or
///                        if `close_block` throws
std::vector<FieldBlock> extract_cloud_blocks(const std::vector<Vec3>& raw, const std::string& name,
                                             const FieldScanOptions& options);

}  // namespace clast::reconstruct_detail
