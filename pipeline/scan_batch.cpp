#include "pipeline/scan_batch.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <new>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/files/digest.hpp"
#include "core/number_text.hpp"
#include "core/ordered_jobs.hpp"
#include "library/library_update.hpp"
#include "pipeline/shape_to_block.hpp"

namespace clast {

namespace {

/// A batch that is killed loses little; a write for every block would copy the library each time.
constexpr std::chrono::seconds kBetweenWrites{60};

/// Outcome of a scan: blocks, reasons for missing blocks, or neither if the library has the block.
struct Outcome {
  std::vector<Block> blocks = {};
  std::vector<std::string> retained = {};  ///< ids of blocks of a split that the library has
  std::vector<std::string> failures = {};
  std::vector<std::string> notes = {};
};

/// A short name of everything that was asked of a scan, for `resume` to know it again.
std::string request_of(const ScanToBlockOptions& options) {
  return "request=" + sha256(format_field(options)).substr(0, 16);
}

std::string digest_of(const ScanFile& scan) {
  return scan.others.empty() ? compute_scan_digest(scan.path) : compute_joined_digest(scan.paths());
}

/// A batch of scans on its way into a library.
class Batch {
 public:
  Batch(const std::vector<ScanFile>& scans, const ScanBatchOptions& options,
        ScanBatchObserver& observer, const ProgressCallback& progress)
      : scans_(scans),
        options_(options),
        observer_(observer),
        progress_(progress),
        request_(request_of(options.scan)),
        scan_options_(options.scan) {
    options.check(scans.size());
    const auto parallel_scans = static_cast<unsigned>(std::clamp<std::size_t>(
        resolve_thread_count(options.jobs), 1, std::max<std::size_t>(scans.size(), 1)));
    scan_options_.block.threads = std::max(1u, resolve_thread_count(0) / parallel_scans);
    if (std::filesystem::exists(options.library)) library_ = BlockLibrary::read(options.library);
    // A place that can't be written is refused before the work and not after it.
    check_library_writable(options.library);
  }

  ScanBatchResult run() {
    try {
      run_ordered_jobs(
          scans_.size(), options_.jobs, [&](std::size_t i) { return outcome_of(scans_[i]); },
          [&](std::size_t i, Outcome& outcome) { take(scans_[i], outcome); });
    } catch (const Cancelled&) {
      save();
      throw;
    }
    save();
    result_.failed_scans = scans_failed_.size();
    result_.blocks = library_.blocks().size();
    return result_;
  }

 private:
  /// A finished block of an unfinished scan.
  struct Held {
    const ScanFile* scan;
    Block block;
  };

  /// A block that is in `library_` and not yet in the file.
  struct Unsaved {
    const ScanFile* scan;
    std::string id;
  };

  bool is_of(const Block& block, const std::string& sha256) const {
    return block.source.options.ends_with(request_) && block.source.sha256 == sha256;
  }

  bool is_split(const ScanFile& scan) const { return options_.scan.split && !scan.is_shp(); }

  /// True if the blocks in the library were made of the same bytes by the same options.
  bool is_done(const ScanFile& scan) {
    check_block_id(scan.id);
    const std::string first = is_split(scan) ? scan.id + "_1" : scan.id;
    const std::lock_guard lock(mutex_);
    if (!library_.contains(first)) return false;
    const Block& block = library_.find_block(first);
    const bool same_request = options_.resume && block.source.options.ends_with(request_);
    if (same_request && block.source.sha256 == digest_of(scan)) {
      return !block.deposit || has_all(scan.id, block.deposit->blocks, block.source.sha256);
    }
    if (options_.replace) return false;
    std::string how;
    if (options_.resume)
      how = same_request ? ", made from another file" : ", made with other options";
    throw InputError("block " + first + " is in " + options_.library.string() + " already" + how +
                     "; use `replace` to put the new one in its place");
  }

  /// True if the library has `count` blocks of a split, all made of the same bytes.
  bool has_all(const std::string& scan_id, std::size_t count, const std::string& sha256) const {
    for (std::size_t i = 1; i <= count; ++i) {
      const std::string id = scan_id + "_" + std::to_string(i);
      if (!library_.contains(id) || !is_of(library_.find_block(id), sha256)) return false;
    }
    return true;
  }

  /// Passes the blocks of a deposit to the observer, in order, with those that the library has.
  void report_deposit(const ScanFile& scan, const std::vector<Block>& made,
                      const std::vector<std::string>& retained, const DepositOrigin& origin) {
    if (retained.empty()) return observer_.on_deposit_made(scan, made, origin);
    std::vector<Block> blocks;
    for (const std::string& id : origin.ids) {
      const auto found = std::find_if(made.begin(), made.end(),
                                      [&](const Block& block) { return block.id == id; });
      if (found != made.end()) {
        blocks.push_back(*found);
      } else if (std::find(retained.begin(), retained.end(), id) != retained.end()) {
        const std::lock_guard lock(mutex_);
        blocks.push_back(library_.find_block(id));
      }
    }
    observer_.on_deposit_made(scan, blocks, origin);
  }

  std::vector<Block> make_blocks(const ScanFile& scan, Outcome& outcome) {
    const std::string sha256 =
        options_.resume && is_split(scan) ? compute_scan_digest(scan.path) : "";
    const ScanCallbacks callbacks = {
        .progress = [&](const ProgressUpdate& step) { report(step); },
        .on_block_made =
            [&](const Block& block, const BlockOrigin& origin) {
              observer_.on_block_made(block, origin);
              if (is_split(scan)) hold(scan, block);
            },
        .on_deposit_made =
            [&](const std::vector<Block>& blocks, const DepositOrigin& origin) {
              report_deposit(scan, blocks, outcome.retained, origin);
            },
        .on_note = [&](const std::string& note) { outcome.notes.push_back(note); },
        .is_known =
            [&](const std::string& id) {
              const std::lock_guard lock(mutex_);
              if (sha256.empty() || !library_.contains(id)) return false;
              if (!is_of(library_.find_block(id), sha256)) return false;
              outcome.retained.push_back(id);
              return true;
            },
        .on_block_lost = [&](const std::string&,
                             const std::string& reason) { outcome.failures.push_back(reason); }};
    if (!scan.others.empty()) {
      return {reconstruct_joined_block(scan.paths(), scan.id, scan_options_, callbacks)};
    }
    if (!scan.is_shp()) {
      return reconstruct_blocks(scan.path, scan.id, scan_options_, callbacks);
    }
    if (!options_.scan.edits.empty()) {
      throw InputError(scan.path.string() + ": is a shape and no scan, so `edits` do not apply");
    }
    if (options_.scan.align) {
      throw InputError(scan.path.string() + ": is a shape and no scan, so `align` does not apply");
    }
    if (!options_.scan.stations.empty()) {
      throw InputError(scan.path.string() + ": is a shape and no scan, so `stations` do not apply");
    }
    const ShpShape shape = scan.shape ? *scan.shape : read_shp(scan.path).front();
    return {make_shape_block(shape, scan.path, scan.id, options_.scan, callbacks)};
  }

  Outcome outcome_of(const ScanFile& scan) {
    Outcome outcome;
    try {
      if (is_done(scan)) return {};
      outcome.blocks = make_blocks(scan, outcome);
      for (Block& block : outcome.blocks) block.source.options += " " + request_;
      return outcome;
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {  // one bad scan never costs the batch
      return {.failures = {error.what()}};
    } catch (const std::bad_alloc&) {
      return {.failures = {"not enough memory; use fewer `jobs`, or simplify the scan first"}};
    } catch (const std::exception& error) {
      return {.failures = {std::string("unexpected failure, please report it: ") + error.what()}};
    }
  }

  void report(ProgressUpdate step) {
    const std::lock_guard lock(mutex_);
    step.done = taken_;
    step.total = scans_.size();
    if (progress_) progress_(step);
  }

  /// Keeps a block of an unfinished scan, so that it is written if the batch is cancelled or
  /// killed.
  void hold(const ScanFile& scan, const Block& block) {
    const std::lock_guard lock(mutex_);
    held_.push_back({&scan, block});
    held_.back().block.source.options += " " + request_;
    save_now_and_then();
  }

  void take(const ScanFile& scan, const Outcome& outcome) {
    const std::lock_guard lock(mutex_);
    ++taken_;
    std::erase_if(held_, [&](const Held& held) { return held.scan == &scan; });
    for (const std::string& note : outcome.notes) observer_.on_note(scan.id + ": " + note);
    for (const Block& block : outcome.blocks) add(scan, block);
    for (const std::string& failure : outcome.failures) fail(scan, failure);
    if (outcome.blocks.empty() && outcome.failures.empty()) {
      keep(scan);
    } else {
      for (const std::string& id : outcome.retained) {
        observer_.on_block_retained(library_.find_block(id));
      }
    }
    note_leftovers(scan, outcome);
    save_now_and_then();
  }

  void add(const ScanFile& scan, const Block& block) {
    try {
      observer_.check_block(block);
      if (written_early_.erase(block.id) == 0) {
        library_.add(block, options_.replace);
        unsaved_.push_back({&scan, block.id});
      }
      ++result_.added;
      observer_.on_block_added(block);
    } catch (const Error& error) {  // such as one of a split scan that is there already
      fail(scan, error.what());
    }
  }

  void fail(const ScanFile& scan, const std::string& reason) {
    scans_failed_.insert(scan.id);
    observer_.on_scan_failed(scan, reason);
  }

  void keep(const ScanFile& scan) {
    ++result_.skipped;
    if (!is_split(scan)) return observer_.on_block_retained(library_.find_block(scan.id));
    for (std::size_t i = 1; library_.contains(scan.id + "_" + std::to_string(i)); ++i) {
      observer_.on_block_retained(library_.find_block(scan.id + "_" + std::to_string(i)));
    }
  }

  /// Blocks of an earlier split into more than now.
  void note_leftovers(const ScanFile& scan, const Outcome& outcome) const {
    if (!options_.scan.split || outcome.blocks.empty() || !outcome.failures.empty()) return;
    const std::string next =
        scan.id + "_" + std::to_string(outcome.blocks.size() + outcome.retained.size() + 1);
    if (!library_.contains(next)) return;
    observer_.on_note(
        options_.library.string() + " still holds block " + next +
        " of an earlier split; if it is obsolete, remove it with clast library remove");
  }

  /// Adds new blocks to the current library, to which other processes may have written meanwhile.
  void save() {
    if (unsaved_.empty() && held_.empty()) return;
    std::vector<std::pair<Unsaved, std::string>> refused;
    const auto waiting = [&] {
      observer_.on_note(options_.library.string() + ": another program is writing to it; waiting");
    };
    library_ = update_library(options_.library, {.create_if_missing = true, .on_wait = waiting},
                              [&](BlockLibrary& library) {
                                for (const Unsaved& one : unsaved_) {
                                  const Block& block = library_.find_block(one.id);
                                  const bool done =
                                      options_.resume && library.contains(one.id) &&
                                      is_of(library.find_block(one.id), block.source.sha256);
                                  if (done) continue;
                                  try {
                                    library.add(block, options_.replace);
                                  } catch (const InputError& error) {  // another process was first
                                    refused.emplace_back(one, error.what());
                                  }
                                }
                                for (const Held& held : held_) {
                                  if (library.contains(held.block.id) && !options_.replace)
                                    continue;
                                  library.add(held.block, options_.replace);
                                  written_early_.insert(held.block.id);
                                }
                              });
    unsaved_.clear();
    std::erase_if(held_, [&](const Held& held) { return written_early_.contains(held.block.id); });
    result_.added -= refused.size();
    for (const auto& [one, reason] : refused) {
      observer_.on_block_refused(one.id);
      fail(*one.scan, reason);
    }
  }

  /// Failed writes are repeated at the end.
  void save_now_and_then() {
    if ((unsaved_.empty() && held_.empty()) ||
        std::chrono::steady_clock::now() - written_ < kBetweenWrites)
      return;
    try {
      save();
    } catch (const Error& error) {
      observer_.on_note(std::string(error.what()) + "; writing is repeated at the end");
    }
    written_ = std::chrono::steady_clock::now();
  }

  const std::vector<ScanFile>& scans_;
  const ScanBatchOptions& options_;
  ScanBatchObserver& observer_;
  const ProgressCallback& progress_;
  std::string request_;
  ScanToBlockOptions scan_options_;  ///< with the threads of one scan
  BlockLibrary library_;             ///< as last read or written, plus what was made since
  std::vector<Unsaved> unsaved_;
  std::vector<Held> held_;
  std::set<std::string> written_early_;  ///< ids of held blocks that are in the file
  std::mutex mutex_;                     ///< of all below, the library and the progress
  std::size_t taken_ = 0;
  ScanBatchResult result_;
  std::set<std::string> scans_failed_;  ///< their ids
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
};

/// Keeps the reasons of what failed.
class Reasons : public ScanBatchObserver {
 public:
  void on_scan_failed(const ScanFile& scan, const std::string& reason) override {
    const bool named = reason.find(scan.path.string()) != std::string::npos;
    text += (text.empty() ? "" : "\n") + (named ? "" : scan.path.string() + ": ") + reason;
  }

  std::string text;
};

}  // namespace

void ScanBatchOptions::check(std::size_t scans) const {
  scan.check();
  if (!scan.edits.empty() && scans != 1) {
    throw InputError("`edits` are for a single scan, but " + std::to_string(scans) +
                     " scans are given");
  }
  if (!scan.stations.empty() && scans != 1) {
    throw InputError("`stations` are those of a single scan, but " + std::to_string(scans) +
                     " scans are given");
  }
  if (!scan.labelled.empty() && scans != 1) {
    throw InputError("`labelled` is for a single scan, but " + std::to_string(scans) +
                     " scans are given");
  }
  if (!scan.block.mass || (scans < 2 && !scan.split)) return;
  throw InputError(
      "`mass` is the mass of a single block, but " +
      (scan.split ? "`split` may make several" : std::to_string(scans) + " scans are given"));
}

ScanBatchResult reconstruct_scan_batch(const std::vector<ScanFile>& scans,
                                       const ScanBatchOptions& options, ScanBatchObserver& observer,
                                       const ProgressCallback& progress) {
  return Batch(scans, options, observer, progress).run();
}

ScanBatchResult reconstruct_scan_batch(const std::vector<ScanFile>& scans,
                                       const ScanBatchOptions& options) {
  Reasons reasons;
  const ScanBatchResult result = reconstruct_scan_batch(scans, options, reasons);
  if (!reasons.text.empty()) throw InputError(reasons.text);
  return result;
}

}  // namespace clast
