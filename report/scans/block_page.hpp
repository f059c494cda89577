#pragma once
/// Page of a block and its scan.
#include <string>

#include "library/block.hpp"
#include "reconstruct/joined_scan.hpp"
#include "reconstruct/photos/photo_summary.hpp"

namespace clast {

/// Scan and options of a block, from which its page is made.
struct BlockPageContents {
  /// Unrepaired mesh, in units and axes of the file; null without a scan.
  const TriangleMesh* raw = nullptr;
  const FieldBlock* field_block = nullptr;
  ScanOptions options = {};    ///< options used for reading the scan
  std::string up = "z";        ///< up axis of the file
  std::string scale = {};      ///< description of the origin of the scale
  bool density_given = false;  ///< true if the density was given; false if a weighed mass was given
  const JoinedScan* joined = nullptr;           ///< joined scans; null for a block of one scan
  const PhotoScan* photos = nullptr;            ///< photo scan; null for other blocks
  const PhotoSummary* photo_summary = nullptr;  ///< summary of the photos; if null, it is computed
};

/// Makes the self-contained page of a block.
std::string make_block_page(const Block& block, const BlockPageContents& scan);

}  // namespace clast
