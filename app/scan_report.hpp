#pragma once
/// Pages about the scans of a batch: one for each block, and a summary.
#include <filesystem>
#include <string>
#include <vector>

#include "core/csv_text.hpp"
#include "core/html_page.hpp"
#include "core/output_file.hpp"
#include "pipeline/scan_to_block.hpp"

namespace clast {

/// What a page of a block is written from. Without a scan (a shape that was read from a .shp file)
/// it has no pictures of one.
struct PagedScan {
  const TriangleMesh* raw = nullptr;
  const FieldBlock* found = nullptr;
  /// How the block got its size, where that is not by the options of the scan.
  std::string scale = {};
  /// Further parts of the page, each made with `section`: they follow what was mended.
  std::vector<std::string> sections = {};
};

/// The page of a block, complete in itself.
std::string block_page(const Block& block, const PagedScan& scan,
                       const ScanToBlockOptions& options);

/// FOLDER/index.html, FOLDER/summary.csv and FOLDER/blocks/ID.html.
class ScanReport {
 public:
  /// @param replace  replace an existing summary of an earlier batch
  /// @throws InputError  the folder can't be made or written to, or holds such a summary and
  ///                     `replace` is false, or a summary.csv or index.html of another kind
  ScanReport(std::filesystem::path folder, bool replace);

  /// Writes the page of a block and adds it to the summary.
  /// @throws InputError  the page can't be written
  void add(const Block& block, const std::string& page);
  /// Adds a block that an earlier batch made; its page is linked where it is there.
  void add_earlier(const Block& block);
  void add_failure(const std::string& scan, const std::string& reason);
  /// Writes the summary. @throws InputError
  void finish();

 private:
  std::filesystem::path page_of(const Block& block) const;
  void add_row(const Block& block, const std::string& outcome);

  std::filesystem::path folder_;
  bool replace_;  ///< pages of an earlier batch
  OutputRules summary_rules_, index_rules_;
  HtmlTable blocks_;
  HtmlTable failures_;
  CsvText csv_;
  std::size_t made_ = 0, earlier_ = 0, failed_ = 0;
};

}  // namespace clast
