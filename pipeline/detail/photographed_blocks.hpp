#pragma once
/// Blocks from a folder of photographs.
#include <filesystem>

#include "library/block.hpp"
#include "pipeline/scan_to_block.hpp"

namespace clast::pipeline_detail {

/// Blocks reconstructed from photographs, with cameras and scale of the photographs.
struct PhotographedBlocks {
  FieldScan field_scan;
  PhotoScan photos;
};

/// Reconstructs the blocks of a folder of photographs.
/// @param reading  options for the points, except for their scale, which is that of the photographs
/// @param source  origin of the blocks, to which the photo data are added
/// @throws InputError, GeometryError  if a step fails; names the folder
PhotographedBlocks reconstruct_photographs(const std::filesystem::path& folder,
                                           const ScanToBlockOptions& options,
                                           FieldScanOptions reading, BlockSource& source,
                                           const ScanCallbacks& callbacks);

}  // namespace clast::pipeline_detail
