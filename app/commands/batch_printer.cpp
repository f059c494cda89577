#include "app/commands/batch_printer.hpp"

#include <filesystem>
#include <iostream>
#include <utility>

#include "app/option_flags.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/shell_words.hpp"
#include "core/utf8.hpp"
#include "reconstruct/photos/photo_summary.hpp"
#include "report/json/block_json.hpp"
#include "report/scans/json/photo_json.hpp"
#include "report/text/block_text.hpp"

namespace clast {

namespace {

std::string describe_block_scale(const ScanToBlockOptions& options) {
  std::string text = "one unit of the file is " + format_significant(options.scan.unit, 6) + " m";
  text += options.scale_points ? " (from a measured length" : " (--units " + options.units;
  if (options.scale_factor != 1.0) {
    text += ", times --scale-factor " + format_significant(options.scale_factor, 6);
  }
  return text + ")";
}

}  // namespace

BatchPrinter::BatchPrinter(std::size_t scans, const ScanBatchOptions& options,
                           const std::string& report, bool json,
                           std::vector<std::string> given_options)
    : options_(options),
      scans_(scans),
      given_options_(std::move(given_options)),
      json_(json),
      bar_("scans", scans) {
  if (!report.empty()) report_.emplace(report, options.replace || options.resume);
}

void BatchPrinter::on_block_made(const Block& block, const BlockOrigin& origin) {
  std::optional<PhotoSummary> evidence;
  if (origin.photos != nullptr && (report_ || json_)) {
    evidence = summarise_photos(*origin.photos, *origin.field_block, origin.up);
    Json photos = photo_json(*origin.photos, *evidence);
    const std::lock_guard lock(mutex_);
    photos_[block.id] = std::move(photos);
  }
  if (!report_) return;
  report_->prepare(block, {.raw = origin.raw,
                           .field_block = origin.field_block,
                           .options = options_.scan.scan,
                           .up = origin.up,
                           .scale = describe_block_scale(options_.scan),
                           .density_given = options_.scan.block.density_given,
                           .joined = origin.joined,
                           .photos = origin.photos,
                           .photo_summary = evidence ? &*evidence : nullptr});
}

void BatchPrinter::on_deposit_made(const ScanFile& scan, const std::vector<Block>& blocks,
                                   const DepositOrigin& origin) {
  if (!report_) return;
  const ScanToBlockOptions& options = options_.scan;
  std::vector<std::string> words = {"clast", "reconstruct", scan.path.string()};
  words.insert(words.end(), given_options_.begin(), given_options_.end());
  words.insert(words.end(), {"--edits", "edits.json", "--replace"});
  report_->prepare_deposit({.name = scan.id,
                            .file = scan.path.string(),
                            .scan = origin.scan,
                            .unit = origin.unit,
                            .up = origin.up,
                            .ids = origin.ids,
                            .blocks = &blocks,
                            .edits = options.edits,
                            .stem = scans_ == 1 ? "deposit" : "deposit_" + scan.id,
                            .next_command = format_shell_command(words)});
}

void BatchPrinter::check_block(const Block& block) { accepted_ = block_json(block); }

void BatchPrinter::on_block_added(const Block& block) {
  std::unique_lock lock(mutex_);
  const auto photos = photos_.extract(block.id);
  lock.unlock();
  made_.push_back(std::move(accepted_));
  if (!photos.empty()) made_.back()["photos"] = photos.mapped();
  bar_.clear();
  if (!json_) {
    std::cout << escape_nonprintable(format_block_line(block)) << "\n";
    for (const std::string& warning : block.warnings) {
      std::cout << "  note: " << format_for_terminal(warning) << "\n";
    }
    std::cout.flush();
  }
  if (!report_) return;
  try {
    report_->add(block);
  } catch (const Error& error) {  // a name too long for a page never costs the batch
    throw InputError("block " + block.id +
                     " was made, but not its page: " + std::string(error.what()));
  }
}

void BatchPrinter::on_block_retained(const Block& block) {
  if (report_) report_->add_earlier(block);
}

void BatchPrinter::on_block_refused(const std::string& id) {
  std::erase_if(made_.get_ref<Json::array_t&>(),
                [&](const Json& json) { return json["id"] == id; });
}

void BatchPrinter::on_scan_failed(const ScanFile& scan, const std::string& reason) {
  bar_.clear();
  const std::string path = scan.path.string();
  if (report_) report_->add_failure(path, reason);
  failed_.push_back({{"scan", to_utf8(path)}, {"reason", to_utf8(replace_keys_by_flags(reason))}});
  const auto print = [&] { std::cerr << "clast: " << format_for_terminal(last_failure_) << "\n"; };
  // The last failure of a single scan ends the program and is printed then.
  if (scans_ == 1 && !last_failure_.empty()) print();
  last_failure_ = reason.find(path) == std::string::npos ? path + ": " + reason : reason;
  if (scans_ > 1) print();
}

void BatchPrinter::on_note(const std::string& text) {
  bar_.clear();
  std::cerr << "clast: " << format_for_terminal(text) << "\n";
}

void BatchPrinter::finish(const ScanBatchResult& result) {
  bar_.clear();
  if (report_) report_->finish();
  print_summary(result);
  if (failed_.empty()) return;
  if (scans_ == 1) throw InputError(last_failure_);
  throw InputError(std::to_string(result.failed_scans) + " of " + std::to_string(scans_) +
                   " scans gave no block" +
                   (options_.scan.split ? ", or not all of their blocks" : "") +
                   "; the reasons are above");
}

void BatchPrinter::print_summary(const ScanBatchResult& result) const {
  if (json_) {
    Json json = {{"blocks", made_}, {"failed", failed_}};
    if (options_.resume) json["skipped"] = result.skipped;
    std::cout << json.dump(2) << "\n";
    return;
  }
  const std::string library = escape_nonprintable(options_.library.string());
  if (result.skipped > 0) {
    std::cout
        << library << ": " << format_count(result.skipped, "scan")
        << " skipped: already in the library, made from the same file with the same options\n";
  }
  if (made_.empty()) return;
  std::cout << library << ": " << format_count(made_.size(), "block") << " written, "
            << result.blocks << " in all\n";
}

}  // namespace clast
