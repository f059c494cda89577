#pragma once
/// Extraction of all blocks of a deposit.
#include <string>
#include <vector>

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

}  // namespace clast::reconstruct_detail
