#include "report/scans/block_page.hpp"

#include <algorithm>
#include <cmath>

#include "core/version.hpp"
#include "library/block_bracket.hpp"
#include "library/unscaled.hpp"
#include "report/blocks/turntable.hpp"
#include "report/html/html_page.hpp"
#include "report/scans/photo_section.hpp"
#include "report/scans/repair_sections.hpp"
#include "report/scans/scan_page.hpp"
#include "report/scans/scan_pictures.hpp"
#include "report/scans/unobserved_surface.hpp"
#include "shapes/surface_deviation.hpp"

namespace clast {

using namespace report_detail;

namespace {

/// Corners that look as round as finer ones in a picture of a page.
constexpr int kSkinSegments = 2;

/// "0.52" or, where a part was not seen, "0.52 (0.48 to 0.56)" or "0.52 (at least 0.48)".
std::string with_bounds(double value, double low, const std::optional<double>& high) {
  if (!high)
    return format_significant_digits(value, 4) + " (at least " + format_significant_digits(low, 4) +
           ")";
  if (low < *high)
    return format_significant_digits(value, 4) + " (" + format_significant_digits(low, 4) + " to " +
           format_significant_digits(*high, 4) + ")";
  return format_significant_digits(value, 4);
}

/// Formats lower and upper L, I and S, such as "0.5 to 0.6; 0.4 to 0.5; 0.2 to 0.4".
std::string format_axes_range(const Vec3& low, const Vec3& high) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    text += (axis == 0 ? "" : "; ") + format_significant_digits(low[axis], 3) + " to " +
            format_significant_digits(high[axis], 3);
  }
  return text;
}

/// Formats the bounds and 90 % intervals of the axes, and the possible classes.
std::string range_facts(const Block& block, const std::string& unit) {
  const BlockBracket range = derive_block_bracket(block);
  const std::string not_known = "not known: too much of the block was not scanned";
  if (!range.axes) return format_fact("bounds of L, I, S; possible shapes", not_known);
  const auto& [low, high] = *range.axes;
  std::string shapes;
  for (const char* scheme : {"sneed-folk", "zingg", "garcia"}) {
    for (const std::string& name : range.classes.at(scheme)) {
      shapes += (shapes.empty() ? "" : ", ") + name;
    }
  }
  std::string html =
      format_fact("bounds of L; I; S, " + unit,
                  format_axes_range({low.L, low.I, low.S}, {high.L, high.I, high.S}));
  if (const std::optional<SizeIntervals>& probable = block.volume_bracket->intervals) {
    html += format_fact("90 % intervals of L; I; S, " + unit,
                        format_axes_range(probable->sides.lower, probable->sides.upper)) +
            format_fact(is_unscaled(block) ? "90 % interval of the volume, cubic units"
                                           : "90 % interval of the volume, m3",
                        format_significant_digits(probable->lower_volume, 3) + " to " +
                            format_significant_digits(probable->upper_volume, 3));
  }
  return html + format_fact("possible shapes", shapes);
}

std::string facts(const Block& block, const std::string& scale) {
  const Axes axes = block.axes();
  double low_volume = 0.0, low_mass = 0.0;
  std::optional<double> high_volume = 0.0, high_mass = 0.0;
  if (block.volume_bracket) {
    const BlockBracket range = derive_block_bracket(block);
    low_volume = block.volume_bracket->lower_volume,
    high_volume = block.volume_bracket->upper_volume;
    low_mass = range.lower_mass, high_mass = range.upper_mass;
  }
  std::string html = "<dl class=\"facts\">";
  const bool metric = !is_unscaled(block);
  const std::string unit = metric ? "m" : "units";
  html += format_fact("L x I x S, " + unit, format_significant_digits(axes.L, 3) + " x " +
                                                format_significant_digits(axes.I, 3) + " x " +
                                                format_significant_digits(axes.S, 3));
  html += format_fact(metric ? "volume, m3" : "volume, cubic units",
                      with_bounds(block.mass.volume, low_volume, high_volume));
  html += format_fact(
      "mass, kg", metric ? with_bounds(block.mass.mass, low_mass, high_mass) : "none: unscaled");
  html += format_fact("density, kg/m3", format_significant_digits(block.density, 4));
  html += format_fact(
      "shape", sneed_folk_class(axes) + ", " + zingg_class(axes) + ", " + garcia_class(axes));
  if (block.volume_bracket) html += range_facts(block, unit);
  html += format_fact("vertices of the block", std::to_string(block.body.vertices.size()));
  html += format_fact("radius of its rounding, " + unit,
                      format_significant_digits(block.body.radius, 3));
  html += format_fact("filled surface, not scanned",
                      block.volume_bracket ? format_percent(block.volume_bracket->filled_fraction)
                                           : "none, or only small holes");
  if (!block.from_core) {
    html += format_fact("largest distance to the scan",
                        format_significant_digits(block.deviation.hausdorff, 2) + " " + unit +
                            " (" + format_percent(block.deviation.hausdorff / axes.L) + " of L)");
  }
  return html + format_fact("scale", metric ? scale : "none") + "</dl>\n";
}

std::string notes(const Block& block) {
  if (!block.warnings.empty()) return format_note_box("Notes", block.warnings);
  return "<div class=\"fine\">The scan was closed and without defects; nothing was "
         "repaired.</div>\n";
}

/// Formats the deviation of the block from the scan: the map and its numbers.
std::string certificate(const Block& block, const FieldBlock& found) {
  const SurfaceDeviation& d = block.deviation;
  const std::string unit = is_unscaled(block) ? " units" : " m";
  std::string html;
  if (d.hausdorff > 0.0) {
    html += draw_deviation_map(rounded_surface_mesh(block.body, kSkinSegments), found.scan.mesh,
                               d.hausdorff, !is_unscaled(block));
  }
  html += "<dl class=\"facts\">";
  html +=
      format_fact("scan to block, at most", format_significant_digits(d.scan_to_body, 3) + unit);
  html +=
      format_fact("block to scan, at most", format_significant_digits(d.body_to_scan, 3) + unit);
  html += format_fact("mean distance", format_significant_digits(d.mean, 3) + unit);
  html += format_fact("volume difference to the scan",
                      format_significant_digits(100.0 * d.volume_relative, 2) + " %");
  html += format_fact("area difference to the scan",
                      format_significant_digits(100.0 * d.area_relative, 2) + " %");
  html += format_fact("principal moments, largest difference",
                      format_significant_digits(100.0 * d.moments_relative, 2) + " %");
  return format_section("The block against the scan",
                        html + "</dl>\n" +
                            format_paragraph("Both largest distances are upper bounds for the "
                                             "whole surface, not only for sampled points."));
}

std::string mass_check(const Block& block, bool density_given) {
  if (is_unscaled(block)) {
    return format_section(
        "Mass", format_paragraph("The block is unscaled: " + explain_unscaled_block() + "."));
  }
  const std::optional<double>& weighed = block.field.weighed_mass;
  if (!weighed) {
    return format_section(
        "Mass",
        format_paragraph(
            "No weighed mass was given: " + format_significant_digits(block.mass.mass, 4) +
            " kg is volume times a density of " + format_significant_digits(block.density, 4) +
            " kg/m3. A weighed mass would be a check of the volume."));
  }
  if (!density_given) {
    return format_section(
        "Mass",
        format_paragraph("The weighed mass of " + format_significant_digits(*weighed, 4) +
                         " kg sets the density: " + format_significant_digits(block.density, 4) +
                         " kg/m3 over the volume of " +
                         format_significant_digits(block.mass.volume, 4) + " m3."));
  }
  const double gap = block.mass.mass / *weighed - 1.0;
  std::string text = "Volume times density gives " + format_significant_digits(block.mass.mass, 4) +
                     " kg, " + format_percent(std::abs(gap)) + (gap < 0.0 ? " less" : " more") +
                     " than the weighed " + format_significant_digits(*weighed, 4) + " kg.";
  if (block.volume_bracket) {
    const double low = block.density * block.volume_bracket->lower_volume;
    const std::optional<double>& upper = block.volume_bracket->upper_volume;
    const bool inside = low <= *weighed && (!upper || *weighed <= block.density * *upper);
    text += " With the unscanned side, the mass can be " +
            (upper ? format_significant_digits(low, 4) + " to " +
                         format_significant_digits(block.density * *upper, 4)
                   : format_significant_digits(low, 4) + " or more") +
            " kg; the weighed mass is " + (inside ? "within this range." : "outside this range.");
  }
  return format_section("Mass check", format_paragraph(text));
}

std::string provenance(const Block& block) {
  HtmlTable table({"what", "value"}, 2);
  table.row({"scan", block.source.file});
  table.row({"SHA-256 of the file", block.source.sha256});
  table.row({"options", block.source.options});
  table.row({"made by", "clast " + block.source.program_version});
  return format_section("Source", table.html());
}

/// How well joined scans fit.
std::string format_join_section(const JoinedScan& joined, const FieldBlock& block) {
  const Registration& fit = joined.registration;
  const auto metres = [](double value) { return format_significant_digits(value, 2) + " m"; };
  const double reach =
      std::max({4.0 * fit.deviation, 4.0 * fit.noise, 1.5 * fit.disagreement, 1e-9});
  std::string html = draw_join_map(block.scan.mesh, joined.distances, reach);
  html += "<dl class=\"facts\">";
  html += format_fact("scans", std::to_string(fit.first_from_scan.size()));
  html += format_fact("least overlap of a scan with the others", format_percent(fit.overlap));
  html += format_fact("distance of the surfaces, root mean square", metres(fit.deviation));
  html += format_fact("standard deviation of the points", metres(fit.noise));
  html += format_fact("part of the overlap that disagrees",
                      fit.disagreeing_fraction > 0.0 ? format_percent(fit.disagreeing_fraction) +
                                                           ", by " + metres(fit.disagreement)
                                                     : "none");
  return format_section("The joined scans", html + "</dl>\n");
}

/// The surface as it was read beside what it became, what was repaired, and the photographs.
std::string scan_sections(const Block& block, const BlockPageContents& scan) {
  if (scan.field_block == nullptr) return {};
  const std::string unit = is_unscaled(block) ? "u" : "m";
  const RepairReport& report = scan.field_block->scan.report;
  ScanOptions options = scan.options;
  options.up = scan.up;
  if (scan.joined != nullptr) options.unit = 1.0;  // joined points are in metres
  std::string html = draw_before_and_after(*scan.raw, options, *scan.field_block,
                                           find_repair_marks(report), !is_unscaled(block));
  if (!scan.field_block->in_deposit) {  // the body of a block of a deposit needs no repair
    html += format_repair_section(report, scan.raw->triangles.empty(),
                                  scan.field_block->underside.has_value(), unit);
  }
  if (scan.field_block->underside)
    html += format_underside_section(*scan.field_block->underside, unit);
  if (scan.joined != nullptr) html += format_join_section(*scan.joined, *scan.field_block);
  if (scan.photos != nullptr) {
    html += format_photo_section(*scan.photos,
                                 scan.photo_summary
                                     ? *scan.photo_summary
                                     : summarise_photos(*scan.photos, *scan.field_block, scan.up),
                                 scan.field_block->scan.mesh);
  }
  return html;
}

std::string format_scan_turntable(const Block& block, const FieldBlock* found) {
  if (found == nullptr || (!found->in_deposit && !found->underside)) {
    return format_turntable_section(block);
  }
  UnobservedSurface unobserved(*found, {});
  return format_turntable_section(block,
                                  [&](const Vec3& place) { return unobserved.contains(place); });
}

}  // namespace

std::string make_block_page(const Block& block, const BlockPageContents& scan) {
  std::string body = "<h1>Block " + escape_html(block.id) +
                     "</h1>\n<p class=\"lead\">from the scan " + escape_html(block.source.file) +
                     "</p>\n";
  if (is_unscaled(block)) {
    body += format_note_box(
        "Unscaled",
        {explain_unscaled_block() +
         ". u is the unit of that model; lengths in m in the notes are in this unit too"});
  }
  body += facts(block, scan.photos ? "by " + scan.photos->scale_source : scan.scale);
  body += notes(block) + format_scan_turntable(block, scan.field_block);
  body += scan_sections(block, scan);
  if (scan.field_block != nullptr && !block.from_core)
    body += certificate(block, *scan.field_block);
  body += mass_check(block, scan.density_given) + provenance(block);
  body += "<footer>clast " + escape_html(version()) + "</footer>\n";
  return make_scan_page("Block " + block.id, body);
}

}  // namespace clast
