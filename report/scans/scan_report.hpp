#pragma once
/// A folder of pages about the scans of a batch: one for each block, and a summary.
#include <filesystem>
#include <memory>
#include <string>

#include "report/scans/block_page.hpp"

namespace clast {

/// FOLDER/index.html, FOLDER/summary.csv and FOLDER/blocks/ID.html.
class ScanReport {
 public:
  /// @param replace  replace an existing summary of an earlier batch
  /// @throws InputError  the folder can't be made or written to, or holds such a summary and
  ///                     `replace` is false, or a summary.csv or index.html of another kind
  ScanReport(std::filesystem::path folder, bool replace);
  ~ScanReport();

  /// Makes the page of a block while what it was made from is in memory; several threads at once.
  void prepare(const Block& block, const ScanOfBlock& scan);
  /// Writes the page of a block that was prepared, and adds the block to the summary.
  /// @throws InputError  the page can't be written
  void add(const Block& block);
  /// Adds a block that an earlier batch made; its page is linked where it is there.
  void add_earlier(const Block& block);
  void add_failure(const std::string& scan, const std::string& reason);
  /// Writes the summary. @throws InputError
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clast
