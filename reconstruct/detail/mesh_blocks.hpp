#pragma once
/// Extraction of blocks from meshes.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// Cleans closed or repairable meshes. For open meshes, removes copies and debris and, if present,
/// the ground, and closes each block.
/// @param name  of the scan, for messages
/// @throws GeometryError  for only ground; and as `clean_block` and `close_block`
std::vector<FieldBlock> extract_mesh_blocks(const TriangleMesh& raw, const std::string& name,
                                            const FieldScanOptions& options);

}  // namespace clast::reconstruct_detail
