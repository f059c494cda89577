#pragma once
/// Scans, one after the other or side by side, on their way into a block library.
#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "pipeline/scan_list.hpp"
#include "pipeline/scan_to_block.hpp"

namespace clast {

/// What is asked of a batch.
struct BatchOptions {
  std::filesystem::path library = "blocks.h5";  ///< blocks are added to one that is there
  unsigned jobs = 1;     ///< scans worked on at the same time; 0: one per core
  bool replace = false;  ///< blocks whose id is there already
  bool resume = false;   ///< passes over scans whose block is there, of the same bytes and options
  ScanToBlockOptions scan;

  /// @param scans  how many there are
  /// @throws InputError  naming the field and its value; a mass for several blocks
  void check(std::size_t scans) const;
};

/// Follows a batch. All but `on_block_made` is called for one scan at a time, in the order of the
/// scans.
class BatchObserver {
 public:
  virtual ~BatchObserver() = default;

  /// A block with what it was made from, on the thread that made it, several at the same time.
  virtual void on_block_made(const Block& /*block*/, const BlockOrigin& /*origin*/) {}
  /// A block before it is taken; an `Error` that this throws keeps it out.
  virtual void check_block(const Block& /*block*/) {}
  /// A block that was taken. What an `Error` thrown here says is counted as a failure of its scan.
  virtual void on_block_added(const Block& /*block*/) {}
  /// A block of an earlier batch, which `resume` keeps.
  virtual void on_block_retained(const Block& /*block*/) {}
  /// A block that another process had added first, after `on_block_added`.
  virtual void on_block_refused(const std::string& /*id*/) {}
  /// A scan, or one of the blocks of a scan, that is not in the library.
  virtual void on_scan_failed(const ScanFile& /*scan*/, const std::string& /*reason*/) {}
  /// Anything else that the user should know.
  virtual void on_note(const std::string& /*text*/) {}
};

/// What became of a batch.
struct BatchResult {
  std::size_t added = 0;         ///< blocks
  std::size_t skipped = 0;       ///< scans whose block was there
  std::size_t failed_scans = 0;  ///< that gave no block, or not all of theirs
  std::size_t blocks = 0;        ///< in the library at the end
};

/// Makes the blocks of the scans and adds them to the library. The library is the same for any
/// number of jobs. A scan that gives no block never costs the others, and what is done is written
/// now and then; so it is when `progress` throws.
/// @throws InputError  the library can't be read or written; what `BatchOptions::check` refuses
BatchResult reconstruct_batch(const std::vector<ScanFile>& scans, const BatchOptions& options,
                              BatchObserver& observer, const ProgressCallback& progress = {});

/// The same without anybody who follows it.
/// @throws InputError  also where a scan gave no block: the reasons of all of them
BatchResult reconstruct_batch(const std::vector<ScanFile>& scans, const BatchOptions& options);

}  // namespace clast
