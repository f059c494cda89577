#include "report/scans/scan_report.hpp"

#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "core/error.hpp"
#include "core/files/csv_writer.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/output_file.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"
#include "core/version.hpp"
#include "library/unscaled.hpp"
#include "report/blocks/block_pictures.hpp"
#include "report/gdal/deposit_layers.hpp"
#include "report/html/html_page.hpp"
#include "report/scans/scan_page.hpp"

namespace clast {

using namespace report_detail;

namespace {

namespace fs = std::filesystem;

/// The beginning of the summary of every version.
constexpr const char* kSummary = "block,outcome,scan,";

}  // namespace

struct ScanReport::Impl {
  fs::path page_of(const Block& block) const { return folder / "blocks" / (block.id + ".html"); }
  void add_row(const Block& block, const std::string& outcome);
  void add_page_row(const Block& block);
  void add_csv_row(const Block& block, const std::string& outcome);
  std::string write_deposits() const;

  fs::path folder;
  bool replace = false;  ///< pages of an earlier batch
  HtmlTable blocks = {{"block and its scan", "picture", "class", "mass kg", "L m", "I m", "S m",
                       "s_c", "volume m3", "filled in %", "deviation from scan, % of L", "notes"},
                      3};
  HtmlTable failures = {{"scan", "reason for failure"}, 2};
  CsvWriter csv = {};
  std::size_t made = 0, earlier = 0, failed = 0;
  std::mutex mutex = {};                             ///< of `pages` and `deposits`
  std::map<std::string, std::string> pages = {};     ///< prepared, by id of the block
  std::map<std::string, DepositPage> deposits = {};  ///< prepared, by file name
};

ScanReport::ScanReport(fs::path folder, bool replace) : impl_(std::make_unique<Impl>()) {
  impl_->folder = std::move(folder);
  impl_->replace = replace;
  impl_->blocks.show_as_cards();
  const fs::path summary = impl_->folder / "summary.csv";
  std::error_code code;
  if (fs::is_regular_file(summary, code) && !read_text_file(summary).starts_with(kSummary)) {
    throw InputError(summary.string() +
                     ": already exists and is not a summary of scan pages, so it is not replaced; "
                     "name another folder");
  }
  check_output_target(summary, {.kind = "text", .replace = replace});
  check_output_target(impl_->folder / "index.html", {.kind = kPageKind, .replace = replace});
  impl_->csv.write_header(
      "block,outcome,scan,L_m,I_m,S_m,volume_m3,volume_lower_m3,volume_upper_m3,invented_share,"
      "density_kg_m3,mass_kg,weighed_kg,sneed_folk,zingg,shape,vertices,radius_m,scan_to_body_m,"
      "body_to_scan_m,notes,sha256,scale,reason");
}

ScanReport::~ScanReport() = default;

void ScanReport::prepare(const Block& block, const BlockPageContents& scan) {
  std::string page = make_block_page(block, scan);
  const std::lock_guard lock(impl_->mutex);
  impl_->pages[block.id] = std::move(page);
}

void ScanReport::prepare_deposit(const DepositPageContents& deposit) {
  DepositPage page = make_deposit_page(deposit);
  const std::lock_guard lock(impl_->mutex);
  impl_->deposits[deposit.stem] = std::move(page);
}

void ScanReport::add(const Block& block) {
  std::unique_lock lock(impl_->mutex);
  const auto page = impl_->pages.extract(block.id);
  lock.unlock();
  write_output(impl_->page_of(block), page.mapped(),
               {.kind = kPageKind, .replace = impl_->replace});
  ++impl_->made;
  impl_->add_row(block, "made");
}

void ScanReport::add_earlier(const Block& block) {
  ++impl_->earlier;
  impl_->add_row(block, "made earlier");
}

void ScanReport::Impl::add_row(const Block& block, const std::string& outcome) {
  add_page_row(block);
  add_csv_row(block, outcome);
}

void ScanReport::Impl::add_page_row(const Block& block) {
  const Axes axes = block.axes();
  const std::optional<VolumeBracket>& unseen = block.volume_bracket;
  const bool metric = !is_unscaled(block);
  const std::string u = metric ? "" : " u";
  std::string name = escape_html(block.id);
  if (fs::exists(page_of(block))) {
    name =
        "<a href=\"" + format_link_target("blocks/" + block.id + ".html") + "\">" + name + "</a>";
  }
  const auto cubed = [&](double volume) {
    return format_significant_digits(volume, 4) + (metric ? "" : " u3");
  };
  std::string volume = cubed(block.mass.volume);
  if (unseen) {
    volume += "<div class=\"range\">" + cubed(unseen->lower_volume) + " to " +
              (unseen->upper_volume ? cubed(*unseen->upper_volume) : "not known") + "</div>";
  }
  blocks.add_html_row({name + "<div class=\"file\">" + escape_html(block.source.file) + "</div>",
                       render_thumbnail(block.surface, block.id),
                       escape_html(garcia_class(axes) + ", " + sneed_folk_class(axes)),
                       metric ? format_significant_digits(block.mass.mass, 4) : "-",
                       format_significant_digits(axes.L, 3) + u,
                       format_significant_digits(axes.I, 3) + u,
                       format_significant_digits(axes.S, 3) + u,
                       format_significant_digits(elongation_index(axes), 3), volume,
                       unseen ? format_fixed(100.0 * unseen->filled_fraction, 1) : "",
                       format_fixed(100.0 * block.deviation.hausdorff / axes.L, 2),
                       std::to_string(block.warnings.size())});
}

void ScanReport::Impl::add_csv_row(const Block& block, const std::string& outcome) {
  const Axes axes = block.axes();
  const std::optional<VolumeBracket>& unseen = block.volume_bracket;
  const bool metric = !is_unscaled(block);
  csv.write_cell(block.id);
  csv.write_cell(outcome);
  csv.write_cell(block.source.file);
  const auto metric_cell = [&](double value) {
    metric ? csv.write_cell(value) : csv.write_empty_cells(1);
  };
  for (const double size : {axes.L, axes.I, axes.S, block.mass.volume}) metric_cell(size);
  if (unseen) {
    metric_cell(unseen->lower_volume);
    metric_cell(unseen->upper_volume.value_or(std::nan("")));
    csv.write_cell(unseen->filled_fraction);
  } else {
    csv.write_empty_cells(3);
  }
  csv.write_cell(block.density);
  metric_cell(block.mass.mass);
  csv.write_cell(block.field.weighed_mass.value_or(std::nan("")));
  csv.write_cell(sneed_folk_class(axes));
  csv.write_cell(zingg_class(axes));
  csv.write_cell(garcia_class(axes));
  csv.write_count(block.body.vertices.size());
  metric_cell(block.body.radius);
  metric_cell(block.deviation.scan_to_body);
  metric_cell(block.deviation.body_to_scan);
  csv.write_count(block.warnings.size());
  csv.write_cell(block.source.sha256);
  csv.write_cell(metric ? "metric" : "none");
  csv.write_empty_cells(1);
  csv.end_row();
}

/// Writes the pages and maps of deposits, and formats links to them.
std::string ScanReport::Impl::write_deposits() const {
  std::string links;
  for (const auto& [stem, page] : deposits) {
    const std::string file = stem + ".html";
    write_output(folder / file, page.html, {.kind = kPageKind, .replace = replace});
    write_deposit_layers(folder / (stem + ".gpkg"), page.map,
                         {.kind = "SQLite", .replace = replace});
    links += "<p><a href=\"" + format_link_target(file) + "\">" + escape_html(file) +
             "</a>: map, 3-D view and corrections of " +
             format_count(page.map.blocks.size(), "block") + "</p>\n";
  }
  // A batch that only continues keeps the page of the earlier run.
  if (links.empty() && earlier > 0 && fs::exists(folder / "deposit.html")) {
    links = "<p><a href=\"deposit.html\">deposit.html</a></p>\n";
  }
  if (links.empty()) return {};
  return format_section(deposits.size() > 1 ? "Deposits" : "Deposit", links);
}

void ScanReport::add_failure(const std::string& scan, const std::string& reason) {
  ++impl_->failed;
  impl_->failures.row({to_utf8(scan), to_utf8(reason)});
  impl_->csv.write_empty_cells(1);
  impl_->csv.write_cell("failed");
  impl_->csv.write_cell(to_utf8(scan));
  impl_->csv.write_empty_cells(20);
  impl_->csv.write_cell(to_utf8(reason));
  impl_->csv.end_row();
}

void ScanReport::finish() {
  std::string body = "<h1>Blocks from scans</h1>\n<p class=\"lead\">" +
                     format_count(impl_->made, "block") + " made";
  if (impl_->earlier > 0) body += ", " + std::to_string(impl_->earlier) + " made earlier";
  if (impl_->failed > 0) body += ", " + format_count(impl_->failed, "scan") + " without a block";
  body += "</p>\n";
  body += impl_->write_deposits();
  if (impl_->failed > 0) body += format_section("Scans that gave no block", impl_->failures.html());
  if (impl_->made + impl_->earlier > 0) {
    body += format_section(
        "Blocks",
        format_paragraph(
            "Click the heading of a column to sort by it. L, I, S are the sides of the smallest "
            "box; the second line in the volume column gives the bounds for a block whose "
            "underside was not scanned. Lengths marked u are in units of an unscaled model.") +
            impl_->blocks.html());
  }
  body += "<footer>clast " + escape_html(version()) +
          "; this page as a table: <a href=\"summary.csv\">summary.csv</a></footer>\n";
  write_output(impl_->folder / "summary.csv", impl_->csv.take_text(),
               {.kind = "text", .replace = impl_->replace});
  write_output(impl_->folder / "index.html", make_scan_page("Blocks from scans", body),
               {.kind = kPageKind, .replace = impl_->replace});
}

}  // namespace clast
