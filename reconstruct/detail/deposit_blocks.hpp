#pragma once
/// Extraction of all blocks of a deposit.
#include <optional>
#include <string>
#include <vector>

#include "reconstruct/detail/cloud_blocks.hpp"
#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// Segments points into blocks and closes each block.
/// @param points  points as read, in the file's units and axes
/// @param name  name of the scan, for messages
/// @throws InputError  if a point is out of range
/// @throws GeometryError  if there are too few points, or no part of the scan is a block
FieldDeposit extract_deposit(const std::vector<Vec3>& points, const std::string& name,
                             const FieldScanOptions& options);

/// Segments the surface of a mesh likewise. A closed body is one block.
FieldDeposit extract_deposit(const TriangleMesh& raw, const std::string& name,
                             const FieldScanOptions& options);

/// Extracts the block near the middle of a cloud as a block of a deposit.
/// @param ground_normal  normal of the ground in the cloud's axes, up; empty if unknown
/// @returns empty if no part of the cloud is a block; without a ground normal, also if there is no
///          strip of ground around a single block
std::optional<FieldBlock> extract_central_block(const CleanCloud& cloud,
                                                const std::optional<Vec3>& ground_normal,
                                                const FieldScanOptions& options);

}  // namespace clast::reconstruct_detail
