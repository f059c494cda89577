#pragma once
/// Report folder of a batch of scans: one page per block and per deposit, and a summary.
#include <filesystem>
#include <memory>
#include <string>

#include "report/scans/block_page.hpp"
#include "report/scans/deposit_page.hpp"

namespace clast {

/// Report folder of a batch of scans, with one page per block and per deposit, and a summary.
class ScanReport {
 public:
  /// Opens the report folder.
  /// @param replace  true if an existing summary is replaced
  /// @throws InputError  if the folder cannot be created or written, a summary exists and `replace`
  ///                     is false, or summary.csv or index.html is of another kind
  ScanReport(std::filesystem::path folder, bool replace);
  ~ScanReport();

  /// Makes the page of a block while its scan is in memory. Thread-safe.
  void prepare(const Block& block, const BlockPageContents& scan);
  /// Writes the prepared page of a block and adds the block to the summary.
  /// @throws InputError  if the page cannot be written
  void add(const Block& block);
  /// Adds a block of an earlier batch to the summary, with a link to its page if the page exists.
  void add_earlier(const Block& block);
  /// Makes the page and the map of a deposit while its scan is in memory. `finish` writes them.
  /// Thread-safe.
  void prepare_deposit(const DepositPageContents& deposit);
  void add_failure(const std::string& scan, const std::string& reason);
  /// Writes the pages and maps of deposits, and the summary page and table.
  /// @throws InputError  if one of them cannot be written
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
