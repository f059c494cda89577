#pragma once
/// From the mesh of a field scan to blocks.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// A closed mesh, or one that repair alone can close or has to refuse, is cleaned. Of an open one
/// copies and scraps are dropped, the ground is removed where there is one, and each block closed.
/// @param name  of the scan, for messages
/// @throws GeometryError  only ground, and what `clean_block` and `close_block` throw
std::vector<FieldBlock> extract_mesh_blocks(const TriangleMesh& raw, const std::string& name,
                                    const FieldScanOptions& options);

}  // namespace clast::reconstruct_detail
