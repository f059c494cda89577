#pragma once
/// The page about one block and the scan it was made of.
#include <string>

#include "library/block.hpp"
#include "reconstruct/field_scan.hpp"
#include "reconstruct/photos/photo_summary.hpp"

namespace clast {

/// What a page of a block is written from. Without a scan (a shape that was read from a .shp file)
/// it has no pictures of one.
struct ScanOfBlock {
  const TriangleMesh* raw = nullptr;  ///< as read, in the file's units and axes
  const FieldBlock* found = nullptr;
  ScanOptions options = {};    ///< with which it was read
  std::string up = "z";        ///< axis of the file that points up, found or asked for
  std::string scale = {};      ///< how the block got its size, in words; of photographs they say it
  bool density_given = false;  ///< else a weighed mass sets the density
  const PhotoScan* photos = nullptr;       ///< of a folder of photographs, else null
  const PhotoSummary* evidence = nullptr;  ///< what these show; null: the page computes it
};

/// The page of a block, complete in itself.
std::string make_block_page(const Block& block, const ScanOfBlock& scan);

}  // namespace clast
