#pragma once
/// Batches of scans into a block library, sequential or parallel.
#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "pipeline/scan_list.hpp"
#include "pipeline/scan_to_block.hpp"

namespace clast {

struct BatchOptions {
  std::filesystem::path library = "blocks.h5";  ///< total number in the library
  unsigned jobs = 1;                            ///< number of parallel scans; 0: one per core
  bool replace = false;                         ///< replace existing blocks of the same id
  bool resume = false;  ///< skip scans whose block exists with equal bytes and options
  ScanToBlockOptions scan;

  /// Checks all options.
  /// @param scans  number of scans
  /// @throws InputError  naming field and value; also for a single mass with several blocks
  void check(std::size_t scans) const;
};

/// Observer of a batch. All calls except `on_block_made` are made for one scan at a time, in scan
/// order.
class BatchObserver {
 public:
  virtual ~BatchObserver() = default;

  /// Called with a new block and its data, on the thread that made it, in parallel.
  virtual void on_block_made(const Block& /*block*/, const BlockOrigin& /*origin*/) {}
  /// Called before a block is added; throwing an `Error` rejects it.
  virtual void check_block(const Block& /*block*/) {}
  /// Called after a block was added; throwing an `Error` counts as failure of the scan.
  virtual void on_block_added(const Block& /*block*/) {}
  /// Called for a block of an earlier batch that `resume` keeps.
  virtual void on_block_retained(const Block& /*block*/) {}
  /// Called if another process added the block first, after it was reported as added.
  virtual void on_block_refused(const std::string& /*id*/) {}
  /// Called for a scan, or a block of a scan, that is not in the library.
  virtual void on_scan_failed(const ScanFile& /*scan*/, const std::string& /*reason*/) {}
  virtual void on_note(const std::string& /*text*/) {}
};

struct BatchResult {
  std::size_t added = 0;         ///< number of added blocks
  std::size_t skipped = 0;       ///< scans whose block existed
  std::size_t failed_scans = 0;  ///< scans without all of their blocks
  std::size_t blocks = 0;        ///< in the library at the end
};

/// Makes the blocks of the scans and adds them to the library, which does not depend on the number
/// of jobs. A failed scan does not affect others. Results are written at intervals, and if
/// `progress` throws.
/// @throws InputError  if the library cannot be read or written, or as `BatchOptions::check`
BatchResult reconstruct_batch(const std::vector<ScanFile>& scans, const BatchOptions& options,
                              BatchObserver& observer, const ProgressCallback& progress = {});

/// Makes the blocks without an observer.
/// @throws InputError  also if any scan failed, with all reasons
BatchResult reconstruct_batch(const std::vector<ScanFile>& scans, const BatchOptions& options);

}  // namespace clast
