#pragma once
/// Extraction of blocks from meshes.
#include <string>
#include <vector>

#include "reconstruct/field_scan.hpp"

namespace clast::reconstruct_detail {

/// True if a mesh is a closed body, or needs only repair to be one.
bool is_closed_body(const TriangleMesh& raw, const ScanOptions& options);

/// Extracts the blocks of a mesh. Closed and repairable meshes are only cleaned. In open meshes,
/// copies, debris and, if present, the ground are removed, and each block is closed.
/// @param name  name of the scan, for messages
/// @throws GeometryError  if there is only ground, or if `clean_block` or `close_block` throws
std::vector<FieldBlock> extract_mesh_blocks(const TriangleMesh& raw, const std::string& name,
                                            const FieldScanOptions& options);

}  // namespace clast::reconstruct_detail
