#include "report/scans/repair_sections.hpp"

#include <algorithm>

#include "core/number_text.hpp"
#include "report/html/html_page.hpp"

namespace clast::report_detail {

namespace {

constexpr std::size_t kMaxHoles = 200;  ///< rows of the table
constexpr std::size_t kMarkedHoles = 9;

std::string length(double metres) { return metres > 0.0 ? format_significant(metres, 3) : ""; }

/// A share that rounds to nothing says so.
std::string share(double value) {
  if (value <= 0.0) return "";
  return value < 5e-4 ? "under 0.1 %" : format_percent(value);
}

std::string closing(const FilledHole& hole) {
  if (!hole.is_fan) return "a smooth surface";
  return hole.border_edges <= 4 ? "a fan" : "triangles between its border points";
}

}  // namespace

std::string format_repair_section(const RepairReport& report, bool cloud, bool open_side,
                                  const std::string& unit) {
  std::string html = format_paragraph(
      (!cloud       ? "As read and welded: "
       : !open_side ? "The surface fitted to the points: "
                    : "The surface fitted to the points, with its open side filled: ") +
      std::to_string(report.as_read.vertices) + " vertices, " +
      std::to_string(report.as_read.triangles) + " triangles; " + report.as_read.summary() + ".");
  if (report.defects.empty()) {
    return format_section(
        "Defects found and repaired",
        html + format_paragraph(
                   report.as_read.is_closed() && !open_side
                       ? "None: the surface was closed and without defects, and was not changed."
                       : "None except the open side, which is described below."));
  }
  HtmlTable defects(
      {"what", "no.", "count", "fraction of surface", "largest " + unit, "at (file's x, y, z)"}, 2);
  std::size_t number = 0;
  for (const Defect& defect : report.defects) {
    defects.row({name_of(defect.kind), std::to_string(++number), std::to_string(defect.count),
                 share(defect.area_fraction), length(defect.size),
                 defect.position ? format_point(*defect.position) : ""});
  }
  html += defects.html();
  if (report.relative_wrap_excess) {
    html += format_paragraph(
        "The self-intersections of the surface could not be removed, so it was wrapped; the " +
        format_percent(*report.relative_wrap_excess) +
        " of volume added by wrapping is removed by scaling.");
  }
  if (!report.holes.empty()) {
    HtmlTable holes({"hole", "closed by", "border edges", "length round " + unit, "radius " + unit,
                     "area " + unit + "2", "fraction of surface", "middle (file's x, y, z)"},
                    2);
    for (std::size_t i = 0; i < std::min(kMaxHoles, report.holes.size()); ++i) {
      const FilledHole& hole = report.holes[i];
      holes.row({"H" + std::to_string(i + 1), closing(hole), std::to_string(hole.border_edges),
                 format_significant(hole.perimeter, 3), format_significant(hole.radius, 3),
                 format_significant(hole.area, 3), share(hole.area_fraction),
                 format_point(hole.centre)});
    }
    html += "<h3>Filled holes, largest first</h3>\n" + holes.html();
    if (report.holes.size() > kMaxHoles) {
      html += format_paragraph("and " + std::to_string(report.holes.size() - kMaxHoles) +
                               " smaller ones.");
    }
  }
  return format_section("Defects found and repaired", html);
}

std::vector<PositionMark> find_repair_marks(const RepairReport& report) {
  std::vector<PositionMark> marks;
  std::size_t number = 0;
  for (const Defect& defect : report.defects) {
    ++number;
    // Holes have marks of their own.
    if (defect.position && defect.kind != DefectKind::kHole) {
      marks.push_back({std::to_string(number), *defect.position});
    }
  }
  for (std::size_t i = 0; i < std::min(kMarkedHoles, report.holes.size()); ++i) {
    marks.push_back({"H" + std::to_string(i + 1), report.holes[i].centre});
  }
  return marks;
}

std::string format_underside_section(const Underside& side, const std::string& unit) {
  HtmlTable table({"shape", "how", "volume " + unit + "3", "difference to best"}, 2);
  const auto row = [&](const char* name, const char* how, double volume) {
    const double change = volume / side.estimated_volume - 1.0;
    table.row({name, how, format_significant(volume, 4),
               (change > 0.0 ? "+" : "") + format_percent(change)});
  };
  row("lower", "filled flat across the rim, with hollows as deep as those of the scanned surface",
      side.lower_volume);
  row("best", "most likely depth below the rim; the block is made from this shape",
      side.estimated_volume);
  std::string text = "The scan is open on the unscanned side: its rim has " +
                     std::to_string(side.rim_edges) + " edges, " +
                     format_significant(side.rim_length, 3) + " " + unit + " round";
  if (side.open_sides > 1) {
    const std::size_t others = side.open_sides - 1;
    text += ", and " + std::to_string(others) +
            (others == 1 ? " other large hole" : " other large holes");
  }
  text += ". " + format_percent(side.filled_fraction) + " of the closed surface is filled. ";
  if (side.upper_volume) {
    row("upper", "scanned flanks continued downwards", *side.upper_volume);
    const double width = (*side.upper_volume - side.lower_volume) / side.estimated_volume;
    text += "The true volume is expected between the lower and the upper volume, which differ by " +
            format_percent(width) + " of the best volume, if " + side.assumption + ".";
  } else {
    text +=
        "Too much of the block was not scanned to give an upper bound of its volume, lengths and "
        "classes; scan more of it.";
  }
  std::string html = format_paragraph(text);
  if (side.ground_clearance > 0.0) {
    html += format_paragraph("The rim is " + format_significant(side.ground_clearance, 3) + " " +
                             unit + " above the ground.");
  }
  return format_section("The unscanned side", html + table.html());
}

}  // namespace clast::report_detail
