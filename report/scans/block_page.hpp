#pragma once
/// Page of a block and its scan.
#include <string>

#include "library/block.hpp"
#include "reconstruct/field_scan.hpp"
#include "reconstruct/photos/photo_summary.hpp"

namespace clast {

/// Data for a block's page. Without a scan (shapes read from .shp files) there are no images of it.
struct ScanOfBlock {
  const TriangleMesh* raw = nullptr;  ///< as read, in the file's units and axes
  const FieldBlock* found = nullptr;
  ScanOptions options = {};  ///< used for reading
  std::string up = "z";      ///< axis of the file that points up
  std::string scale =
      {};  ///< how the scale was determined, as text; photo scans state it themselves
  bool density_given = false;              ///< false: a weighed mass determines the density
  const PhotoScan* photos = nullptr;       ///< null unless the block was made from photographs
  const PhotoSummary* evidence = nullptr;  ///< summary of the photos; null: computed here
};

/// Makes the self-contained page of a block.
std::string make_block_page(const Block& block, const ScanOfBlock& scan);

}  // namespace clast
