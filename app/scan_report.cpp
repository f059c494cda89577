#include "app/scan_report.hpp"

#include <cmath>
#include <utility>

#include "app/block_report.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/output_file.hpp"
#include "core/text_file.hpp"
#include "core/utf8.hpp"
#include "core/version.hpp"
#include "library/unscaled.hpp"
#include "library/unseen_range.hpp"
#include "reconstruct/report/repair_sections.hpp"
#include "reconstruct/report/scan_page.hpp"
#include "reconstruct/report/scan_pictures.hpp"

namespace clast {

namespace {

namespace fs = std::filesystem;

/// Corners that no camera of a page could tell from rounder ones.
constexpr int kSkinSegments = 2;

/// The beginning of the summary of every version.
constexpr const char* kSummary = "block,outcome,scan,";

std::string scale_in_words(const ScanToBlockOptions& options) {
  std::string text = "one unit of the file is " + with_digits(options.scan.unit, 6) + " m";
  text += options.scale_points ? " (from a measured length" : " (--units " + options.units;
  if (options.scale_factor != 1.0) {
    text += ", times --scale-factor " + with_digits(options.scale_factor, 6);
  }
  return text + ")";
}

/// "0.52" or, where a part was not seen, "0.52 (0.48 to 0.56)" or "0.52 (at least 0.48)".
std::string with_bounds(double value, double low, const std::optional<double>& high) {
  if (!high) return rounded(value) + " (at least " + rounded(low) + ")";
  if (low < *high) return rounded(value) + " (" + rounded(low) + " to " + rounded(*high) + ")";
  return rounded(value);
}

/// Bounds of the axes and every class they allow.
std::string range_facts(const Block& block, const std::string& unit) {
  const UnseenRange range = unseen_range(block);
  const std::string not_known = "not known: too much of the block was not seen";
  if (!range.axes) return fact("bounds of L, I, S; possible shapes", not_known);
  const auto& [low, high] = *range.axes;
  const auto between = [](double from, double to) {
    return rounded(from, 3) + " to " + rounded(to, 3);
  };
  std::string shapes;
  for (const char* scheme : {"sneed-folk", "zingg", "garcia"}) {
    for (const std::string& name : range.classes.at(scheme)) {
      shapes += (shapes.empty() ? "" : ", ") + name;
    }
  }
  return fact("bounds of L; I; S, " + unit, between(low.L, high.L) + "; " + between(low.I, high.I) +
                                                "; " + between(low.S, high.S)) +
         fact("possible shapes", shapes);
}

std::string facts(const Block& block, const std::string& scale) {
  const Axes axes = block.axes();
  double low_volume = 0.0, low_mass = 0.0;
  std::optional<double> high_volume = 0.0, high_mass = 0.0;
  if (block.unseen) {
    const UnseenRange range = unseen_range(block);
    low_volume = block.unseen->lower_volume, high_volume = block.unseen->upper_volume;
    low_mass = range.lower_mass, high_mass = range.upper_mass;
  }
  std::string html = "<dl class=\"facts\">";
  const bool metric = !is_unscaled(block);
  const std::string unit = metric ? "m" : "units";
  html += fact("L x I x S, " + unit,
               rounded(axes.L, 3) + " x " + rounded(axes.I, 3) + " x " + rounded(axes.S, 3));
  html += fact(metric ? "volume, m3" : "volume, cubic units",
               with_bounds(block.mass.volume, low_volume, high_volume));
  html += fact("mass, kg",
               metric ? with_bounds(block.mass.mass, low_mass, high_mass) : "none: unscaled");
  html += fact("density, kg/m3", rounded(block.density));
  html +=
      fact("shape", sneed_folk_class(axes) + ", " + zingg_class(axes) + ", " + garcia_class(axes));
  if (block.unseen) html += range_facts(block, unit);
  html += fact("vertices of the block", std::to_string(block.body.vertices.size()));
  html += fact("radius of its rounding, " + unit, rounded(block.body.radius, 3));
  html += fact("surface not seen but filled in",
               block.unseen ? percent(block.unseen->invented_share) : "none, or small holes alone");
  if (!block.from_core) {
    html +=
        fact("farthest from the scan", rounded(block.deviation.hausdorff, 2) + " " + unit + " (" +
                                           percent(block.deviation.hausdorff / axes.L) + " of L)");
  }
  return html + fact("scale", metric ? scale : "none") + "</dl>\n";
}

std::string notes(const Block& block) {
  if (!block.warnings.empty()) return note_box("Notes", block.warnings);
  return "<div class=\"fine\">The scan was closed and sound; nothing was mended.</div>\n";
}

/// How far the block is off the scan: the map and the numbers that go with it.
std::string certificate(const Block& block, const FieldBlock& found) {
  const Deviation& d = block.deviation;
  const std::string unit = is_unscaled(block) ? " units" : " m";
  std::string html;
  if (d.hausdorff > 0.0) {
    html += deviation_map(skin_mesh(block.body, kSkinSegments), found.scan.mesh, d.hausdorff,
                          !is_unscaled(block));
  }
  html += "<dl class=\"facts\">";
  html += fact("scan to block, at most", rounded(d.scan_to_body, 3) + unit);
  html += fact("block to scan, at most", rounded(d.body_to_scan, 3) + unit);
  html += fact("mean distance", rounded(d.mean, 3) + unit);
  html += fact("volume against the scan", rounded(100.0 * d.volume_relative, 2) + " %");
  html += fact("area against the scan", rounded(100.0 * d.area_relative, 2) + " %");
  html += fact("principal moments, at most", rounded(100.0 * d.moments_relative, 2) + " %");
  return section("The block against the scan",
                 html + "</dl>\n" +
                     paragraph("Both largest distances are upper bounds over the whole of either "
                               "surface, not of samples."));
}

std::string mass_check(const Block& block, const ScanToBlockOptions& options) {
  if (is_unscaled(block)) {
    return section("Mass", paragraph("The block is unscaled: " + unscaled_reason() + "."));
  }
  const std::optional<double>& weighed = block.field.weighed_mass;
  if (!weighed) {
    return section("Mass", paragraph("No weighed mass was given: " + rounded(block.mass.mass) +
                                     " kg is volume times a density of " + rounded(block.density) +
                                     " kg/m3. A weighed mass (--mass) would check the volume."));
  }
  if (!options.block.density_given) {
    return section("Mass",
                   paragraph("The weighed mass of " + rounded(*weighed) +
                             " kg sets the density: " + rounded(block.density) +
                             " kg/m3 over the volume of " + rounded(block.mass.volume) + " m3."));
  }
  const double gap = block.mass.mass / *weighed - 1.0;
  std::string text = "Volume times density gives " + rounded(block.mass.mass) + " kg, " +
                     percent(std::abs(gap)) + (gap < 0.0 ? " less" : " more") +
                     " than the weighed " + rounded(*weighed) + " kg.";
  if (block.unseen) {
    const double low = block.density * block.unseen->lower_volume;
    const std::optional<double>& upper = block.unseen->upper_volume;
    const bool inside = low <= *weighed && (!upper || *weighed <= block.density * *upper);
    text += " The unseen side allows " +
            (upper ? rounded(low) + " to " + rounded(block.density * *upper)
                   : rounded(low) + " or more") +
            " kg, which the weighed mass is " + (inside ? "within." : "outside of.");
  }
  return section("Mass check", paragraph(text));
}

std::string provenance(const Block& block) {
  HtmlTable table({"what", "value"}, 2);
  table.row({"scan", block.source.file});
  table.row({"SHA-256 of the file", block.source.sha256});
  table.row({"options", block.source.options});
  table.row({"made by", "clast " + block.source.program_version});
  return section("Where it comes from", table.html());
}

}  // namespace

std::string block_page(const Block& block, const PagedScan& scan,
                       const ScanToBlockOptions& options) {
  std::string body = "<h1>Block " + escaped(block.id) + "</h1>\n<p class=\"lead\">from the scan " +
                     escaped(block.source.file) + "</p>\n";
  if (is_unscaled(block)) {
    body += note_box(
        "Unscaled",
        {unscaled_reason() + ". u is a unit of that model; where notes say m they mean it too"});
  }
  body += facts(block, scan.scale.empty() ? scale_in_words(options) : scan.scale) + notes(block);
  if (scan.found != nullptr) {
    const RepairReport& report = scan.found->scan.report;
    body += before_and_after(*scan.raw, options.scan, *scan.found, repair_marks(report),
                             !is_unscaled(block));
    body += repair_section(report, scan.raw->triangles.empty(), scan.found->underside.has_value(),
                           length_unit_of(block));
    if (scan.found->underside)
      body += underside_section(*scan.found->underside, length_unit_of(block));
  }
  for (const std::string& further : scan.sections) body += further;
  if (scan.found != nullptr && !block.from_core) body += certificate(block, *scan.found);
  body += mass_check(block, options) + provenance(block);
  body += "<footer>clast " + escaped(version()) + "</footer>\n";
  return scan_page("Block " + block.id, body);
}

ScanReport::ScanReport(fs::path folder, bool replace)
    : folder_(std::move(folder)),
      replace_(replace),
      blocks_({"block", "picture", "scan", "L m", "I m", "S m", "volume m3", "volume from",
               "volume to", "filled in %", "mass kg", "s_c", "off scan, % of L", "notes"},
              3),
      failures_({"scan", "why there is no block"}, 2) {
  const fs::path summary = folder_ / "summary.csv";
  std::error_code code;
  if (fs::is_regular_file(summary, code) && !read_text_file(summary).starts_with(kSummary)) {
    throw InputError(summary.string() +
                     ": already exists and is not a summary of such pages, so it is not replaced; "
                     "name another folder");
  }
  summary_rules_ = check_output(summary, {.kind = "text", .replace = replace});
  index_rules_ = check_output(folder_ / "index.html", {.kind = "HTML", .replace = replace});
  csv_.header(
      "block,outcome,scan,L_m,I_m,S_m,volume_m3,volume_lower_m3,volume_upper_m3,invented_share,"
      "density_kg_m3,mass_kg,weighed_kg,sneed_folk,zingg,shape,vertices,radius_m,scan_to_body_m,"
      "body_to_scan_m,notes,sha256,scale,reason");
}

fs::path ScanReport::page_of(const Block& block) const {
  return folder_ / "blocks" / (block.id + ".html");
}

void ScanReport::add(const Block& block, const std::string& page) {
  write_output(page_of(block), page, {.kind = "HTML", .replace = replace_});
  ++made_;
  add_row(block, "made");
}

void ScanReport::add_earlier(const Block& block) {
  ++earlier_;
  add_row(block, "made earlier");
}

void ScanReport::add_row(const Block& block, const std::string& outcome) {
  const Axes axes = block.axes();
  const std::optional<UnseenPart>& unseen = block.unseen;
  const bool metric = !is_unscaled(block);
  const std::string u = metric ? "" : " u";
  std::string name = escaped(block.id);
  if (fs::exists(page_of(block))) {
    name = "<a href=\"" + link_to("blocks/" + block.id + ".html") + "\">" + name + "</a>";
  }
  const auto cubed = [&](double volume) { return rounded(volume) + (metric ? "" : " u3"); };
  std::string from, to;
  if (unseen) {
    from = cubed(unseen->lower_volume);
    to = unseen->upper_volume ? cubed(*unseen->upper_volume) : "not known";
  }
  blocks_.html_row({name, thumbnail(block.surface, block.id), escaped(block.source.file),
                    rounded(axes.L, 3) + u, rounded(axes.I, 3) + u, rounded(axes.S, 3) + u,
                    rounded(block.mass.volume) + (metric ? "" : " u3"), from, to,
                    unseen ? fixed(100.0 * unseen->invented_share, 1) : "", mass_text(block),
                    rounded(elongation_s_c(axes), 3),
                    fixed(100.0 * block.deviation.hausdorff / axes.L, 2),
                    std::to_string(block.warnings.size())});

  csv_.cell(block.id);
  csv_.cell(outcome);
  csv_.cell(block.source.file);
  const auto metric_cell = [&](double value) { metric ? csv_.cell(value) : csv_.empty_cells(1); };
  for (const double size : {axes.L, axes.I, axes.S, block.mass.volume}) metric_cell(size);
  if (unseen) {
    metric_cell(unseen->lower_volume);
    metric_cell(unseen->upper_volume.value_or(std::nan("")));
    csv_.cell(unseen->invented_share);
  } else {
    csv_.empty_cells(3);
  }
  csv_.cell(block.density);
  metric_cell(block.mass.mass);
  csv_.cell(block.field.weighed_mass.value_or(std::nan("")));
  csv_.cell(sneed_folk_class(axes));
  csv_.cell(zingg_class(axes));
  csv_.cell(garcia_class(axes));
  csv_.count(block.body.vertices.size());
  metric_cell(block.body.radius);
  metric_cell(block.deviation.scan_to_body);
  metric_cell(block.deviation.body_to_scan);
  csv_.count(block.warnings.size());
  csv_.cell(block.source.sha256);
  csv_.cell(metric ? "metric" : "none");
  csv_.empty_cells(1);
  csv_.end_row();
}

void ScanReport::add_failure(const std::string& scan, const std::string& reason) {
  ++failed_;
  failures_.row({as_utf8(scan), as_utf8(reason)});
  csv_.empty_cells(1);
  csv_.cell("failed");
  csv_.cell(as_utf8(scan));
  csv_.empty_cells(20);
  csv_.cell(as_utf8(reason));
  csv_.end_row();
}

void ScanReport::finish() {
  std::string body =
      "<h1>Blocks from scans</h1>\n<p class=\"lead\">" + counted(made_, "block") + " made";
  if (earlier_ > 0) body += ", " + std::to_string(earlier_) + " made earlier";
  if (failed_ > 0) body += ", " + counted(failed_, "scan") + " without a block";
  body += "</p>\n";
  if (failed_ > 0) body += section("Scans that gave no block", failures_.html());
  if (made_ + earlier_ > 0) {
    body += section("Blocks",
                    paragraph("A click on a column's head sorts by it. L, I, S are the "
                              "sides of the smallest box; volumes from and to are the "
                              "bounds of a block whose underside was not seen. Lengths marked "
                              "u are in units of an unscaled model.") +
                        blocks_.html());
  }
  body += "<footer>clast " + escaped(version()) +
          "; the same as a table: <a href=\"summary.csv\">summary.csv</a></footer>\n";
  write_output(folder_ / "summary.csv", csv_.take(), summary_rules_);
  write_output(folder_ / "index.html", scan_page("Blocks from scans", body), index_rules_);
}

}  // namespace clast
