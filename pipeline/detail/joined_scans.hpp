#pragma once
/// Reading of several scans of one block.
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/scan_to_block.hpp"
#include "reconstruct/joined_scan.hpp"

namespace clast::pipeline_detail {

/// Reads and joins scans: meshes, clouds and folders of photographs.
/// @param id  id of the block, for messages
/// @param reading  options of the surface and of the ground
/// @throws InputError, GeometryError  if a scan cannot be read or the scans do not fit
JoinedScan read_joined_scans(const std::vector<std::filesystem::path>& paths, const std::string& id,
                             const ScanToBlockOptions& options, const FieldScanOptions& reading,
                             const ScanCallbacks& callbacks);

}  // namespace clast::pipeline_detail
