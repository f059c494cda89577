#pragma once
/// Page of a block and its scan.
#include <string>

#include "library/block.hpp"
#include "reconstruct/field_scan.hpp"
#include "reconstruct/photos/photo_summary.hpp"

namespace clast {

/// Data for the page of a block. Blocks from .shp files have no scan and no images of it.
struct BlockPageContents {
  const TriangleMesh* raw =
      nullptr;  ///< mesh as read, in units and axes of the file; null without a scan
  const FieldBlock* field_block = nullptr;
  ScanOptions options = {};  ///< options used for reading the scan
  std::string up = "z";      ///< up axis of the file
  std::string scale = {};    ///< text on the origin of the scale; not used for photo scans
  bool density_given =
      false;  ///< true if the density was given; false if it follows from a weighed mass
  const PhotoScan* photos =
      nullptr;  ///< photo scan; null if the block was not made from photographs
  const PhotoSummary* photo_summary = nullptr;  ///< summary of the photos; if null, it is computed
};

/// Makes the self-contained page of a block.
std::string make_block_page(const Block& block, const BlockPageContents& scan);

}  // namespace clast
