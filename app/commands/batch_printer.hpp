#pragma once
/// Output of `clast reconstruct` for a batch of scans.
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/progress_bar.hpp"
#include "pipeline/scan_batch.hpp"
#include "report/scans/scan_report.hpp"

namespace clast {

/// Prints the blocks of a batch of scans to stdout, as lines or JSON, and failures to stderr.
/// Optionally writes report pages.
class BatchPrinter : public ScanBatchObserver {
 public:
  /// Starts the output of a batch.
  /// @param scans  number of scans
  /// @param report  folder of pages; if empty, no pages are written
  /// @param json  true if blocks are printed as JSON at the end; false if as lines
  /// @param given_options  options of the command line with their values, without `--edits` and
  ///                       `--replace`, for the command that applies edits, which pages state
  /// @throws InputError  if the folder of pages cannot be written
  BatchPrinter(std::size_t scans, const ScanBatchOptions& options, const std::string& report,
               bool json, std::vector<std::string> given_options);

  void on_block_made(const Block& block, const BlockOrigin& origin) override;
  void on_deposit_made(const ScanFile& scan, const std::vector<Block>& blocks,
                       const DepositOrigin& origin) override;
  void check_block(const Block& block) override;
  void on_block_added(const Block& block) override;
  void on_block_retained(const Block& block) override;
  void on_block_refused(const std::string& id) override;
  void on_scan_failed(const ScanFile& scan, const std::string& reason) override;
  void on_note(const std::string& text) override;

  /// Updates the progress bar.
  void show(const ProgressUpdate& step) {
    bar_.update(step.done, step.activity, step.is_slow && options_.jobs == 1);
  }
  /// Prints the summary and writes the summary page.
  /// @throws InputError  if a scan gave no block; states the reason if there is a single scan
  void finish(const ScanBatchResult& result);

 private:
  using Json = nlohmann::ordered_json;

  void print_summary(const ScanBatchResult& result) const;

  const ScanBatchOptions& options_;
  std::size_t scans_;
  std::vector<std::string> given_options_;  ///< of the command line, for pages
  bool json_;
  ProgressBar bar_;
  std::optional<ScanReport> report_;
  std::mutex mutex_;                    ///< protects `photos_`
  std::map<std::string, Json> photos_;  ///< JSON of photo scans, by block id
  Json accepted_;                       ///< JSON of the block that is added next
  Json made_ = Json::array(), failed_ = Json::array();
  std::string last_failure_;
};

}  // namespace clast
