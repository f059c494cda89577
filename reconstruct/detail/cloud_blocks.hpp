#pragma once
/// From the points of a field scan to blocks.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// Leaves out repeats, outliers and what lies far from the block, removes the ground where there is
/// one, and closes each block.
/// @param name  of the scan, for messages
/// @throws InputError     a point out of reach; too few points
/// @throws GeometryError  separate sets without a ground, only ground, and what `close_block`
/// throws
std::vector<FieldBlock> extract_cloud_blocks(const std::vector<Vec3>& raw, const std::string& name,
                                     const FieldScanOptions& options);

}  // namespace clast::reconstruct_detail
