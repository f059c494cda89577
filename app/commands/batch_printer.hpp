#pragma once
/// What `clast reconstruct` prints and writes about a batch of scans.
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/progress_bar.hpp"
#include "pipeline/scan_batch.hpp"
#include "report/scans/scan_report.hpp"

namespace clast {

/// Lines or JSON on stdout, failures on stderr, a page for each block where pages are wanted.
class BatchPrinter : public BatchObserver {
 public:
  /// @param scans   how many there are
  /// @param report  folder of pages; empty: none are written
  /// @param json    blocks as JSON at the end, not as lines
  /// @throws InputError  the folder of pages can't be written
  BatchPrinter(std::size_t scans, const BatchOptions& options, const std::string& report,
               bool json);

  void made(const Block& block, const BlockOrigin& origin) override;
  void accept(const Block& block) override;
  void added(const Block& block) override;
  void kept(const Block& block) override;
  void refused(const std::string& id) override;
  void failed(const ScanFile& scan, const std::string& reason) override;
  void noted(const std::string& text) override;

  /// Of scans side by side no step has a line of its own.
  void show(const ProgressUpdate& step) {
    bar_.update(step.done, step.what, step.is_slow && options_.jobs == 1);
  }
  /// The summary, on stdout and among the pages.
  /// @throws InputError  a scan gave no block; of a single scan its own reason
  void finish(const BatchResult& result);

 private:
  using Json = nlohmann::ordered_json;

  void print_end(const BatchResult& result) const;

  const BatchOptions& options_;
  std::size_t scans_;
  bool json_;
  ProgressBar bar_;
  std::optional<ScanReport> report_;
  std::mutex mutex_;                    ///< of `photos_`
  std::map<std::string, Json> photos_;  ///< of blocks that are made, by id
  Json accepted_;                       ///< the block that is taken next
  Json made_ = Json::array(), failed_ = Json::array();
  std::string last_failure_;
};

}  // namespace clast
