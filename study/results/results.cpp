#include "study/results/results.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>

#include "core/error.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/file_lock.hpp"
#include "core/files/output_file.hpp"
#include "core/number_text.hpp"
#include "study/results/detail/results_layout.hpp"
#include "study/results/results_file.hpp"

namespace clast {

using namespace study_detail;
namespace fs = std::filesystem;

const PersistentBlockRecord* CampaignResults::find_persistent_block(std::uint32_t run) const {
  const auto found = std::lower_bound(
      persistent_block_records.begin(), persistent_block_records.end(), run,
      [](const PersistentBlockRecord& record, std::uint32_t other) { return record.run < other; });
  return found != persistent_block_records.end() && found->run == run ? &*found : nullptr;
}

fs::path results_journal_path(const fs::path& target) {
  fs::path part = target;
  part += ".part";
  return part;
}

void check_results_target(const fs::path& target, bool replace) {
  check_output_target(target, {.kind = kResultsFormat, .replace = replace});
}

bool has_finished_results(const fs::path& target, const CampaignHeader& header, std::size_t runs) {
  if (detect_file_kind(target) != kResultsFormat) return false;
  const CampaignResults stored = read_results(target);
  std::string difference = describe_campaign_difference(stored, header);
  if (difference.empty() && stored.runs.size() != runs) {
    difference = format_count(stored.runs.size(), "run") + ", where this one has " +
                 std::to_string(runs) + " (another shard)";
  }
  if (difference.empty()) return true;
  throw InputError(target.string() + ": holds the finished results of " + difference +
                   "; `replace` replaces them, or give another name");
}

namespace {

/// Held while the file is being written: two programs would mix their runs.
std::unique_ptr<FileLock> locked(const fs::path& target) {
  check_results_target(target, true);
  return std::make_unique<FileLock>(target,
                                    FileLockOptions{.timeout = std::chrono::milliseconds(0)});
}

}  // namespace

struct ResultsWriter::Impl {
  std::unique_ptr<FileLock> lock;
  fs::path target;
  CampaignHeader header;
  ResultsJournal journal;
  std::vector<std::uint32_t> stored;
};

ResultsWriter::ResultsWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ResultsWriter::~ResultsWriter() = default;
ResultsWriter::ResultsWriter(ResultsWriter&&) noexcept = default;

ResultsWriter ResultsWriter::create(const fs::path& target, const CampaignHeader& header,
                                    std::size_t runs) {
  std::unique_ptr<FileLock> lock = locked(target);
  check_results_disk_space(target, header, runs);
  return ResultsWriter(
      std::unique_ptr<Impl>(new Impl{std::move(lock),
                                     target,
                                     header,
                                     ResultsJournal::create(results_journal_path(target), header),
                                     {}}));
}

ResultsWriter ResultsWriter::resume(const fs::path& target, const CampaignHeader& header,
                                    std::size_t runs) {
  std::unique_ptr<FileLock> lock = locked(target);
  ResultsJournal journal = ResultsJournal::resume(results_journal_path(target), header);
  std::vector<std::uint32_t> stored = journal.run_indices();
  std::sort(stored.begin(), stored.end());
  check_results_disk_space(target, header, runs - std::min(runs, stored.size()));
  CampaignHeader with_old_runs = header;
  with_old_runs.physics_digest = journal.physics_digest();
  return ResultsWriter(std::unique_ptr<Impl>(new Impl{
      std::move(lock), target, std::move(with_old_runs), std::move(journal), std::move(stored)}));
}

const std::vector<std::uint32_t>& ResultsWriter::completed_runs() const { return impl_->stored; }

void ResultsWriter::add(const StoredRun& run) {
  impl_->journal.add(run);
  const std::uint32_t number = run.record.run;
  impl_->stored.insert(std::lower_bound(impl_->stored.begin(), impl_->stored.end(), number),
                       number);
}

void ResultsWriter::finish() {
  const std::vector<std::uint32_t>& runs = impl_->journal.run_indices();
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return runs[a] < runs[b]; });
  write_results_file(impl_->target, impl_->header, order.size(),
                     [&](std::size_t i) { return impl_->journal.read(order[i]); });
  std::error_code code;  // what is left of it is harmless
  fs::remove(impl_->journal.path(), code);
  impl_->lock.reset();
}

}  // namespace clast
