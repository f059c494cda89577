#pragma once
/// Processing of batches of scans into a block library, sequentially or in parallel.
#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.hpp"
#include "pipeline/scan_list.hpp"
#include "pipeline/scan_to_block.hpp"

namespace clast {

struct ScanBatchOptions {
  std::filesystem::path library = "blocks.h5";  ///< library to which the blocks are added
  unsigned jobs = 1;                            ///< number of parallel scans; 0: one per core
  bool replace = false;  ///< true: existing blocks with the same id are replaced
  bool resume = false;   ///< true: scans are skipped if their block exists and was made from the
                         ///< same bytes with the same options
  ScanToBlockOptions scan;

  /// Checks all options.
  /// @param scans  number of scans
  /// @throws InputError  if an option is invalid, or a single mass is given for several blocks;
  ///                     names field and value
  void check(std::size_t scans) const;
};

/// Observer of a batch. All functions except `on_block_made` and `on_deposit_made` are called for
/// one scan at a time, in the order of the scans.
class ScanBatchObserver {
 public:
  virtual ~ScanBatchObserver() = default;

  /// Called with a new block and its data on the thread that made it; calls may be concurrent.
  virtual void on_block_made(const Block& /*block*/, const BlockOrigin& /*origin*/) {}
  /// Called with all blocks of a split scan, also retained ones, on the thread that made them,
  /// unless all are retained. Calls may be concurrent.
  virtual void on_deposit_made(const ScanFile& /*scan*/, const std::vector<Block>& /*blocks*/,
                               const DepositOrigin& /*origin*/) {}
  /// Called before a block is added. The block is rejected if an `Error` is thrown.
  virtual void check_block(const Block& /*block*/) {}
  /// Called after a block was added. The scan fails if an `Error` is thrown.
  virtual void on_block_added(const Block& /*block*/) {}
  /// Called for a block of an earlier batch that `resume` keeps.
  virtual void on_block_retained(const Block& /*block*/) {}
  /// Called if a block reported as added is not written, because another process has added its id.
  virtual void on_block_refused(const std::string& /*id*/) {}
  /// Called for a scan, or a block of a scan, that could not be added to the library.
  virtual void on_scan_failed(const ScanFile& /*scan*/, const std::string& /*reason*/) {}
  virtual void on_note(const std::string& /*text*/) {}
};

struct ScanBatchResult {
  std::size_t added = 0;         ///< number of added blocks
  std::size_t skipped = 0;       ///< number of scans whose block existed
  std::size_t failed_scans = 0;  ///< number of scans of which a block is missing
  std::size_t blocks = 0;        ///< number of blocks in the library at the end
};

/// Makes the blocks of the scans and adds them to the library. The result does not depend on the
/// number of jobs. A failed scan does not affect the others. The library is written at intervals,
/// and if `progress` throws.
/// @throws InputError  if the library cannot be read or written, or if `ScanBatchOptions::check`
/// throws
ScanBatchResult reconstruct_scan_batch(const std::vector<ScanFile>& scans,
                                       const ScanBatchOptions& options, ScanBatchObserver& observer,
                                       const ProgressCallback& progress = {});

/// Makes the blocks of the scans and adds them to the library, without an observer.
/// @throws InputError  if the other overload would throw, or if a scan failed; states all reasons
ScanBatchResult reconstruct_scan_batch(const std::vector<ScanFile>& scans,
                                       const ScanBatchOptions& options);

}  // namespace clast
