#include "app/scan_batch.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <set>

#include "app/block_report.hpp"
#include "app/ordered_jobs.hpp"
#include "app/photo_json.hpp"
#include "app/progress.hpp"
#include "app/scan_list.hpp"
#include "app/shape_to_block.hpp"
#include "app/text_table.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/utf8.hpp"
#include "library/library_update.hpp"
#include "report/scans/block_page.hpp"
#include "report/scans/photo_section.hpp"
#include "report/scans/scan_report.hpp"

namespace clast {
namespace {

/// What became of a scan: blocks, or the reasons why some or all are missing, or neither where the
/// library has its block already.
struct Outcome {
  std::vector<Block> blocks;
  std::vector<std::string> pages;                        ///< of the blocks, where they are wanted
  std::map<std::string, nlohmann::ordered_json> photos;  ///< of blocks from photographs, by id
  std::vector<std::string> failures;
};

/// How a scan got its size, for its page.
std::string scale_in_words(const ScanToBlockOptions& options) {
  std::string text = "one unit of the file is " + with_digits(options.scan.unit, 6) + " m";
  text += options.scale_points ? " (from a measured length" : " (--units " + options.unit_name;
  if (options.scale_factor != 1.0) {
    text += ", times --scale-factor " + with_digits(options.scale_factor, 6);
  }
  return text + ")";
}

/// @param paged     are pages wanted?
/// @param detailed  is what photos showed wanted?
Outcome outcome_of(const ScanFile& scan, const ScanToBlockOptions& options, bool paged,
                   bool detailed, const std::function<void(const std::string&)>& stage) {
  Outcome outcome;
  PagedScan shown{.options = options.scan,
                  .scale = scale_in_words(options),
                  .density_given = options.block.density_given};
  if (scan.is_shp()) {
    const ShpShape shape = scan.shape ? *scan.shape : read_shp(scan.path).front();
    outcome.blocks = {block_from_shape(shape, scan.path, scan.id, options, stage)};
    if (paged) outcome.pages = {block_page(outcome.blocks[0], shown)};
    return outcome;
  }
  BlockWitness witness;
  if (paged || (detailed && std::filesystem::is_directory(scan.path))) {
    witness = [&](const Block& block, const TriangleMesh& raw, const FieldBlock& found,
                  const PhotoScan* photos) {
      shown.raw = &raw;
      shown.found = &found;
      shown.sections.clear();
      if (photos != nullptr) {
        const PhotoEvidence evidence = photo_evidence(*photos, found, options.scan.up);
        shown.sections.push_back(photo_section(*photos, evidence, found.scan.mesh));
        shown.scale = "by " + photos->scale_source;
        outcome.photos[block.id] = photo_json(*photos, evidence);
      }
      if (paged) outcome.pages.push_back(block_page(block, shown));
    };
  }
  const BlockLoss lost = [&](const std::string&, const std::string& reason) {
    outcome.failures.push_back(reason);
  };
  outcome.blocks = blocks_from_scan(scan.path, scan.id, options, stage, witness, lost);
  return outcome;
}

/// A short name of everything that was asked of a scan, for `--resume` to know it again.
std::string request(const ScanToBlockOptions& options) {
  return "request=" + sha256(field_text(options)).substr(0, 16);
}

/// A batch of scans on its way into a library.
class Batch {
 public:
  explicit Batch(const ScanBatch& args)
      : args_(args),
        scans_(list_scans(args.scans)),
        request_(request(args.options)),
        progress_("steps", kStages * scans_.size()) {
    if (args.options.block.mass && scans_.size() > 1) {
      throw CLI::ValidationError("--mass", "is the mass of one block, but " +
                                               std::to_string(scans_.size()) + " scans are given");
    }
    if (std::filesystem::exists(args.library)) library_ = BlockLibrary::read(args.library);
    // A place that can't be written is refused before the work and not after it.
    check_library_place(args.library);
    if (!args.report.empty()) report_.emplace(args.report, args.replace || args.resume);
  }

  void run() {
    ordered_jobs(
        scans_.size(), args_.jobs, [&](std::size_t i) { return made(scans_[i]); },
        [&](std::size_t i, Outcome& outcome) { take(scans_[i], outcome); });
    progress_.clear();
    save();
    if (report_) report_->finish();
    print_end();
    if (failed_.empty()) return;
    if (scans_.size() == 1) throw InputError(last_failure_);
    throw InputError(std::to_string(scans_failed_.size()) + " of " + std::to_string(scans_.size()) +
                     " scans gave no block" +
                     (args_.options.split ? ", or not all of theirs" : "") +
                     "; the reasons are above");
  }

 private:
  static constexpr std::size_t kStages = 3;
  /// A batch that is killed loses little; a write for every block would copy the library each time.
  static constexpr std::chrono::seconds kBetweenWrites{60};

  void tell(const std::string& what) {
    const std::lock_guard lock(mutex_);
    progress_.update(std::min(steps_++, kStages * scans_.size()), what);
  }

  bool is_of(const Block& block, const std::string& sha256) const {
    return block.source.options.ends_with(request_) && block.source.sha256 == sha256;
  }

  /// True where the block in the library was made of the same bytes by the same options.
  bool is_done(const ScanFile& scan) {
    check_block_id(scan.id);
    const std::string first = args_.options.split && !scan.is_shp() ? scan.id + "_1" : scan.id;
    const std::lock_guard lock(mutex_);
    if (!library_.has(first)) return false;
    const BlockSource& source = library_.block(first).source;
    const bool same_request = args_.resume && source.options.ends_with(request_);
    if (same_request && source.sha256 == digest_of_scan(scan.path)) return true;
    if (args_.replace) return false;
    std::string how;
    if (args_.resume) how = same_request ? ", made of another file" : ", made with other options";
    throw InputError("block " + first + " is in " + args_.library + " already" + how +
                     "; use --replace to put the new one in its place");
  }

  Outcome made(const ScanFile& scan) {
    try {
      if (is_done(scan)) return {};
      Outcome outcome = outcome_of(scan, args_.options, report_.has_value(), args_.json,
                                   [&](const std::string& what) { tell(what); });
      for (Block& block : outcome.blocks) block.source.options += " " + request_;
      return outcome;
    } catch (const Error& error) {  // one bad scan never costs the batch
      return {{}, {}, {}, {error.what()}};
    } catch (const std::bad_alloc&) {
      return {{}, {}, {}, {"not enough memory; use fewer --jobs, or thin the scan first"}};
    } catch (const std::exception& error) {
      return {{}, {}, {}, {std::string("unexpected failure, please report it: ") + error.what()}};
    }
  }

  void take(const ScanFile& scan, Outcome& outcome) {
    const std::lock_guard lock(mutex_);
    progress_.clear();
    steps_ = std::max(steps_, kStages * ++taken_);
    for (std::size_t i = 0; i < outcome.blocks.size(); ++i) {
      try {
        add(scan, outcome.blocks[i]);
        const auto photos = outcome.photos.find(outcome.blocks[i].id);
        if (photos != outcome.photos.end()) made_.back()["photos"] = photos->second;
        if (report_) write_page(scan, outcome.blocks[i], outcome.pages[i]);
      } catch (const Error& error) {  // such as one of a split scan that is there already
        lose(scan, error.what());
      }
    }
    for (const std::string& failure : outcome.failures) lose(scan, failure);
    if (outcome.blocks.empty() && outcome.failures.empty()) skip(scan);
    tell_leftovers(scan, outcome);
    save_now_and_then();
  }

  /// A scan, or a block of one, that is not in the library.
  void lose(const ScanFile& scan, const std::string& reason) {
    if (report_) report_->add_failure(scan.path.string(), reason);
    fail(scan, reason);
  }

  /// Blocks of an earlier split into more than now.
  void tell_leftovers(const ScanFile& scan, const Outcome& outcome) const {
    if (!args_.options.split || outcome.blocks.empty() || !outcome.failures.empty()) return;
    const std::string next = scan.id + "_" + std::to_string(outcome.blocks.size() + 1);
    if (!library_.has(next)) return;
    std::cerr << "clast: " << printable(args_.library) << " still holds block " << printable(next)
              << " of an earlier split; if it is obsolete, use clast library remove\n";
  }

  /// Adds what was made since the last time to the library as it is now, which other processes may
  /// have written to meanwhile.
  void save() {
    if (unsaved_.empty()) return;
    std::vector<std::pair<Unsaved, std::string>> refused;
    const auto waiting = [&] {
      progress_.clear();
      std::cerr << "clast: " << args_.library << ": another program is writing to it; waiting\n";
    };
    library_ = update_library(
        args_.library, {.make = true, .waiting = waiting}, [&](BlockLibrary& library) {
          for (const Unsaved& one : unsaved_) {
            const Block& block = library_.block(one.id);
            const bool done = args_.resume && library.has(one.id) &&
                              is_of(library.block(one.id), block.source.sha256);
            if (done) continue;
            try {
              library.add(block, args_.replace);
            } catch (const InputError& error) {  // another process was first
              refused.emplace_back(one, error.what());
            }
          }
        });
    unsaved_.clear();
    for (const auto& [one, reason] : refused) {
      std::erase_if(made_.get_ref<nlohmann::ordered_json::array_t&>(),
                    [&](const nlohmann::ordered_json& json) { return json["id"] == one.id; });
      lose(*one.scan, reason);
    }
  }

  /// What can't be written now is tried again at the end.
  void save_now_and_then() {
    if (unsaved_.empty() || std::chrono::steady_clock::now() - written_ < kBetweenWrites) return;
    try {
      save();
    } catch (const Error& error) {
      std::cerr << "clast: " << printable(error.what()) << "; writing is tried again at the end\n";
    }
    written_ = std::chrono::steady_clock::now();
  }

  void fail(const ScanFile& scan, const std::string& reason) {
    const std::string path = scan.path.string();
    failed_.push_back({{"scan", as_utf8(path)}, {"reason", as_utf8(reason)}});
    scans_failed_.insert(scan.id);
    // The last failure of a single scan ends the program and is printed then.
    if (scans_.size() == 1 && !last_failure_.empty()) print_failure();
    last_failure_ = reason.find(path) == std::string::npos ? path + ": " + reason : reason;
    if (scans_.size() > 1) print_failure();
  }

  void print_failure() const { std::cerr << "clast: " << printable(last_failure_) << "\n"; }

  void write_page(const ScanFile& scan, const Block& block, const std::string& page) {
    try {
      report_->add(block, page);
    } catch (const Error& error) {  // a name too long for a page never costs the batch
      fail(scan, "block " + block.id + " was made, but not its page: " + std::string(error.what()));
    }
  }

  void skip(const ScanFile& scan) {
    ++skipped_;
    if (!report_) return;
    for (const Block* block : blocks_of(scan)) report_->add_earlier(*block);
  }

  /// Those that the library has of a scan.
  std::vector<const Block*> blocks_of(const ScanFile& scan) const {
    if (!args_.options.split || scan.is_shp()) return {&library_.block(scan.id)};
    std::vector<const Block*> blocks;
    for (std::size_t i = 1; library_.has(scan.id + "_" + std::to_string(i)); ++i) {
      blocks.push_back(&library_.block(scan.id + "_" + std::to_string(i)));
    }
    return blocks;
  }

  void add(const ScanFile& scan, const Block& block) {
    nlohmann::ordered_json json = block_json(block);  // may refuse the block: before it is taken
    library_.add(block, args_.replace);
    unsaved_.push_back({&scan, block.id});
    made_.push_back(std::move(json));
    if (args_.json) return;
    std::cout << printable(block_line(block)) << "\n";
    for (const std::string& warning : block.warnings) {
      std::cout << "  note: " << printable(warning) << "\n";
    }
    std::cout.flush();
  }

  void print_end() const {
    if (args_.json) {
      nlohmann::ordered_json json = {{"blocks", made_}, {"failed", failed_}};
      if (args_.resume) json["skipped"] = skipped_;
      std::cout << json.dump(2) << "\n";
      return;
    }
    if (skipped_ > 0) {
      std::cout << printable(args_.library) << ": " << counted(skipped_, "scan")
                << " skipped, in the library already with the same file and options\n";
    }
    if (made_.empty()) return;
    std::cout << printable(args_.library) << ": " << counted(made_.size(), "block") << " written, "
              << library_.blocks().size() << " in all\n";
  }

  /// A block that is in `library_` and not yet in the file.
  struct Unsaved {
    const ScanFile* scan;
    std::string id;
  };

  const ScanBatch& args_;
  std::vector<ScanFile> scans_;
  std::string request_;
  Progress progress_;
  BlockLibrary library_;  ///< as last read or written, plus what was made since
  std::vector<Unsaved> unsaved_;
  std::optional<ScanReport> report_;
  std::mutex mutex_;  ///< of all below, the library and the progress
  std::size_t steps_ = 0, taken_ = 0, skipped_ = 0;
  nlohmann::ordered_json made_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json failed_ = nlohmann::ordered_json::array();
  std::string last_failure_;
  std::set<std::string> scans_failed_;  ///< their ids
  std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
};

}  // namespace

void add_to_library(const ScanBatch& batch) { Batch(batch).run(); }

}  // namespace clast
