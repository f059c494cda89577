#pragma once
/// The page about one block and the scan it was made of.
#include <string>
#include <vector>

#include "library/block.hpp"
#include "reconstruct/field_scan.hpp"

namespace clast {

/// What a page of a block is written from. Without a scan (a shape that was read from a .shp file)
/// it has no pictures of one.
struct PagedScan {
  const TriangleMesh* raw = nullptr;  ///< as read, in the file's units and axes
  const FieldBlock* found = nullptr;
  ScanOptions options = {};    ///< with which it was read
  std::string scale = {};      ///< how the block got its size, in words
  bool density_given = false;  ///< else a weighed mass sets the density
  /// Further parts of the page, such as `photo_section`: they follow what was repaired.
  std::vector<std::string> sections = {};
};

/// The page of a block, complete in itself.
std::string block_page(const Block& block, const PagedScan& scan);

}  // namespace clast
