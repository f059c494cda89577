#pragma once
/// Scans, one after the other or side by side, on their way into a block library.
#include <string>
#include <vector>

#include "app/scan_to_block.hpp"

namespace clast {

/// What is asked of a batch.
struct ScanBatch {
  std::vector<std::string> scans;  ///< files and folders
  std::string library = "blocks.h5";
  unsigned jobs = 1;     ///< scans worked on at the same time; 0: one per core
  bool replace = false;  ///< blocks whose id is there already
  bool resume = false;   ///< passes over scans whose block is there, of the same bytes and options
  bool json = false;     ///< prints the blocks as JSON, not as lines
  std::string report;    ///< folder of pages; empty: none are written
  ScanToBlockOptions options;
};

/// Makes the blocks, adds them to the library, and tells of each on stdout, of failures on stderr.
/// The results are the same for any number of jobs. A scan that gives no block never costs the
/// others, and what is done is written now and then.
/// @throws InputError  scans that gave no block, after the others are written; with one scan alone
///                     its own reason
/// @throws CLI::ValidationError  a mass for several scans
void add_to_library(const ScanBatch& batch);

}  // namespace clast
