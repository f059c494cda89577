#pragma once
/// Blocks out of a folder of photographs.
#include <filesystem>

#include "library/block.hpp"
#include "pipeline/scan_to_block.hpp"

namespace clast::pipeline_detail {

/// What was found, with the cameras and the scale of the photographs.
struct PhotographedBlocks {
  FieldScan found;
  PhotoScan photos;
};

/// @param reading  of the points; its scale is that of the photographs
/// @param source   of the blocks: what the photographs say of it is added
/// @throws InputError, GeometryError  with the folder in the message
PhotographedBlocks reconstruct_photographs(const std::filesystem::path& folder,
                                           const ScanToBlockOptions& options,
                                           FieldScanOptions reading, BlockSource& source,
                                           const ScanCallbacks& callbacks);

}  // namespace clast::pipeline_detail
