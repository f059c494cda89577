#include "report/scans/photo_section.hpp"

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "core/comma_separated.hpp"
#include "core/number_text.hpp"
#include "report/html/html_page.hpp"
#include "report/scans/scan_pictures.hpp"

namespace clast {

using namespace report_detail;

namespace {

constexpr double kPhotoPlanWidth = 620.0, kPhotoPlanHeight = 520.0;  ///< of the plan, px
constexpr double kMargin = 46.0;
constexpr int kOutline = 72;  ///< directions in which the block's outline is looked for

constexpr const char* kBlue = "#0072B2";
constexpr const char* kOrange = "#C77700";

/// Colours of triangles by how many photos see them, and the words for them.
struct ViewColour {
  std::uint16_t minimum;
  Rgb colour;
  const char* words;
};
constexpr std::array<ViewColour, 5> kViewColours = {{{0, {213, 94, 0}, "none"},
                                                     {1, {240, 228, 170}, "1 or 2"},
                                                     {3, {153, 205, 187}, "3 or 4"},
                                                     {5, {65, 148, 190}, "5 to 9"},
                                                     {10, {34, 70, 148}, "10 or more"}}};

std::string degrees(double angle) {
  return format_fixed(angle * kDegreesPerRadian, 0) + "\xC2\xB0";
}

/// Transforms metres about the middle of the block to the page.
struct Plan {
  double pixel = 1.0;  ///< px per m
  Vec2 operator()(double x, double y) const {
    return {0.5 * kPhotoPlanWidth + pixel * x, 0.5 * kPhotoPlanHeight - pixel * y};
  }
  Vec2 around(double azimuth, double distance) const {
    return (*this)(distance * std::cos(azimuth), distance * std::sin(azimuth));
  }
};

std::string coordinates(const Vec2& p) {
  return format_fixed(p.x(), 1) + "," + format_fixed(p.y(), 1);
}

/// The block from above, as its hull.
std::string outline(const Plan& plan, const TriangleMesh& surface, const Vec3& middle) {
  std::string points;
  for (int k = 0; k < kOutline; ++k) {
    const double azimuth = 2.0 * kPi * k / kOutline;
    const Vec3 out(std::cos(azimuth), std::sin(azimuth), 0.0);
    const auto farthest =
        std::max_element(surface.vertices.begin(), surface.vertices.end(),
                         [&](const Vec3& a, const Vec3& b) { return out.dot(a) < out.dot(b); });
    points += coordinates(plan(farthest->x() - middle.x(), farthest->y() - middle.y())) + " ";
  }
  return "<polygon points=\"" + points +
         "\" fill=\"#d6cdbe\" stroke=\"#5b6775\" stroke-width=\"1\"/>";
}

std::string wedge(const Plan& plan, const AzimuthGap& gap, double reach) {
  const Vec2 from = plan.around(gap.from, reach), to = plan.around(gap.from + gap.width, reach);
  const double radius = plan.pixel * reach;
  const Vec2 label = plan.around(gap.from + 0.5 * gap.width, 0.72 * reach);
  return "<path d=\"M" + coordinates(plan(0.0, 0.0)) + " L" + coordinates(from) + " A" +
         format_fixed(radius, 1) + "," + format_fixed(radius, 1) + " 0 " +
         (gap.width > kPi ? "1" : "0") + " 0 " + coordinates(to) + " Z\" class=\"gap\" fill=\"" +
         kOrange + "\" fill-opacity=\".14\"/>" +
         svg_text(label.x(), label.y() + 5, degrees(gap.width),
                  "font-size=\"14\" text-anchor=\"middle\" fill=\"#8a5200\"");
}

std::string state_of(const CameraPosition& seat) {
  if (seat.blurred) return "blurred, skipped";
  return seat.pairs > 0 ? "compared" : "no matching photo at a suitable angle";
}

std::string mark(const Vec2& at, const CameraPosition& seat) {
  const std::string title = "<title>" + escape_html(seat.name + ": " + state_of(seat)) + "</title>";
  const std::string place =
      "cx=\"" + format_fixed(at.x(), 1) + "\" cy=\"" + format_fixed(at.y(), 1) + "\"";
  if (seat.blurred) {
    return "<g class=\"seat blurred\" stroke=\"" + std::string(kOrange) +
           "\" stroke-width=\"2.5\">" + title +
           format_svg_line(at.x() - 5, at.y() - 5, at.x() + 5, at.y() + 5, "") +
           format_svg_line(at.x() - 5, at.y() + 5, at.x() + 5, at.y() - 5, "") + "</g>";
  }
  const bool used = seat.pairs > 0;
  return "<circle class=\"seat " + std::string(used ? "compared" : "alone") + "\" " + place +
         " r=\"5\" fill=\"" + (used ? kBlue : "#fff") + "\" stroke=\"" + kBlue +
         "\" stroke-width=\"1.6\">" + title + "</circle>";
}

/// Cameras from above, about the block.
std::string ring_plan(const PhotoSummary& evidence, const TriangleMesh& surface,
                      const Vec3& middle) {
  double reach = 0.0;
  const auto flat = [](const CameraPosition& seat) {
    return seat.distance * std::cos(seat.elevation);
  };
  for (const CameraPosition& seat : evidence.ring.cameras) reach = std::max(reach, flat(seat));
  if (reach <= 0.0) return "";
  const Plan plan{(0.5 * std::min(kPhotoPlanWidth, kPhotoPlanHeight) - kMargin) / reach};
  std::string svg = open_svg(kPhotoPlanWidth, kPhotoPlanHeight, "cameras from above");
  for (const AzimuthGap& gap : evidence.ring.gaps) svg += wedge(plan, gap, reach);
  svg += outline(plan, surface, middle);
  for (const CameraPosition& seat : evidence.ring.cameras) {
    svg += mark(plan.around(seat.azimuth, flat(seat)), seat);
  }
  const char* const axis = "stroke=\"#1d2733\" stroke-width=\"1.4\"";
  const double x = 22.0, y = kPhotoPlanHeight - 22.0;
  svg += format_svg_line(x, y, x + 34, y, axis) + format_svg_line(x, y, x, y - 34, axis) +
         svg_text(x + 38, y + 5, "x", "font-size=\"13\"") +
         svg_text(x - 3, y - 39, "y", "font-size=\"13\"");
  return format_figure(svg + "</svg>",
                       "Cameras seen from above, in the frame of the block. Filled circles: photos "
                       "matched with others. Open circles: photos without a matching photo. "
                       "Crosses: blurred photos. Orange sectors: no matched photo over more than " +
                           degrees(kWideAzimuthGap) + ".");
}

std::string gap_words(const CameraRing& ring) {
  std::string text;
  for (const AzimuthGap& gap : ring.gaps) {
    text += (text.empty() ? "" : "; ") + degrees(gap.width) + " from azimuth " + degrees(gap.from) +
            ", between " + ring.cameras[gap.first].name + " and " + ring.cameras[gap.second].name;
  }
  return "Gaps around the block: " + text +
         ". Take photos there, one every 10 to 15 degrees, for a better surface.";
}

std::string photo_table(const CameraRing& ring, const std::string& unit) {
  HtmlTable table(
      {"photo", "state", "pairs", "azimuth, deg", "elevation, deg", "distance, " + unit}, 2);
  for (const CameraPosition& seat : ring.cameras) {
    table.row({seat.name, state_of(seat), std::to_string(seat.pairs),
               format_fixed(seat.azimuth * kDegreesPerRadian, 1),
               format_fixed(seat.elevation * kDegreesPerRadian, 1),
               format_significant_digits(seat.distance, 3)});
  }
  return "<details><summary>Every photo</summary>" + table.html() + "</details>\n";
}

std::string coverage_map(const PhotoSummary& evidence, const TriangleMesh& surface, bool metric) {
  const auto colour = [&](std::uint32_t triangle) {
    Rgb found = kViewColours[0].colour;
    for (const ViewColour& one : kViewColours) {
      if (evidence.views.photos[triangle] >= one.minimum) found = one.colour;
    }
    return found;
  };
  std::string html = draw_coloured_views(
      surface, colour,
      "The closed scan, coloured by the number of matched photos that see each part.", metric);
  std::string key = open_svg(560, 26, "colour scale of the number of photos");
  double x = 4.0;
  for (const ViewColour& one : kViewColours) {
    const auto& [r, g, b] = one.colour;
    key += "<rect x=\"" + format_fixed(x, 0) + "\" y=\"5\" width=\"16\" height=\"16\" fill=\"rgb(" +
           std::to_string(r) + "," + std::to_string(g) + "," + std::to_string(b) + ")\"/>" +
           svg_text(x + 22, 18, one.words, "font-size=\"13\"");
    x += 112.0;
  }
  html += "<div class=\"colours\">" + key + "</svg></div>\n";
  HtmlTable table({"seen by at least", "photos, % of the surface", "pairs, % of the surface"}, 1);
  for (const ViewCoverage& one : evidence.coverage) {
    table.row({std::to_string(one.min_views), format_fixed(100.0 * one.photos, 1),
               format_fixed(100.0 * one.pairs, 1)});
  }
  return html + table.html();
}

std::string marker_table(const PhotoSummary& evidence, const std::string& unit) {
  HtmlTable table({"marker", "for the scale", "photos", "error, px", "side, " + unit}, 2);
  for (const MarkerUsage& marker : evidence.markers) {
    const bool placed = marker.side > 0.0;
    table.row({std::to_string(marker.id), marker.used ? "used" : marker.reason,
               std::to_string(marker.photos), placed ? format_fixed(marker.error, 2) : "-",
               placed ? format_significant_digits(marker.side, 5) : "-"});
  }
  return table.html();
}

std::string scale_table(const PhotoScale& scale) {
  HtmlTable table({"length", "for the scale", "stated, m", "in the model, m", "scale, m per unit",
                   "error against the others, %"},
                  2);
  for (const ComparedLength& one : scale.measures) {
    table.row({one.name, one.used ? "used" : "left out", format_significant_digits(one.length, 6),
               format_significant_digits(one.length / one.factor * scale.metres_per_unit, 6),
               format_significant_digits(one.factor, 7),
               scale.measures.size() > 1 ? format_fixed(100.0 * one.leave_one_out_error, 3) : "-"});
  }
  std::string words = "One unit of the cameras' model is " +
                      format_significant_digits(scale.metres_per_unit, 7) + " m";
  if (scale.spread > 0.0)
    words += "; the lengths that set the scale differ by " + format_fixed(100.0 * scale.spread, 3) +
             " % (standard deviation)";
  words += ". The last column is the error of a length if only the others set the scale.";
  if (scale.marker_side_ratio) {
    words += " With this scale, the sides of the markers are " +
             format_fixed(100.0 * std::abs(*scale.marker_side_ratio), 2) + " % " +
             (*scale.marker_side_ratio > 0.0 ? "longer" : "shorter") + " than stated.";
  }
  return table.html() + format_paragraph(words) +
         (scale.notes.empty() ? "" : format_note_box("About the scale", scale.notes));
}

std::string scale_part(const PhotoScan& scan, const PhotoSummary& evidence,
                       const std::string& unit) {
  std::string html = "<h3>Scale</h3>\n";
  if (!evidence.markers.empty()) html += marker_table(evidence, unit);
  if (!scan.corners.empty()) {
    std::size_t fewest = scan.corners.front().photos;
    double worst = 0.0;
    for (const BoardCorner& corner : scan.corners) {
      fewest = std::min(fewest, corner.photos);
      worst = std::max(worst, corner.error);
    }
    html += format_paragraph("ChArUco board: " + format_count(scan.corners.size(), "corner") +
                             ", each in " + format_count(fewest, "photo") + " or more, within " +
                             format_fixed(worst, 2) + " px.");
  }
  if (scan.scale) return html + scale_table(*scan.scale);
  return html + format_paragraph(scan.metric
                                     ? "Source of the scale: " + scan.scale_source +
                                           ". There is no marker in the photos to check it."
                                     : "There is no scale: lengths are in units of the camera "
                                       "model, and the block has no mass. Give a scale bar, a "
                                       "board, the size of the markers or a measured length.");
}

}  // namespace

std::string format_photo_section(const PhotoScan& scan, const PhotoSummary& evidence,
                                 const TriangleMesh& surface) {
  const CameraRing& ring = evidence.ring;
  const std::string unit = scan.metric ? "m" : "units";
  std::vector<std::string> blurred, alone;
  for (const CameraPosition& seat : ring.cameras) {
    if (seat.blurred) {
      blurred.push_back(seat.name);
    } else if (seat.pairs == 0) {
      alone.push_back(seat.name);
    }
  }
  std::vector<std::string> notes;
  if (!ring.gaps.empty()) notes.push_back(gap_words(ring));
  const auto left_out = [&](const std::string& what, const std::vector<std::string>& names) {
    if (!names.empty()) {
      notes.push_back(format_count(names.size(), "photo") + " " + what + ": " +
                      comma_separated(names));
    }
  };
  left_out("without a camera", scan.photos_without_camera);
  left_out("blurred and skipped", blurred);
  left_out("without a matching photo 6 to 32 degrees away", alone);
  const std::size_t compared = ring.cameras.size() - blurred.size() - alone.size();
  std::string html = format_paragraph(
      format_count(ring.cameras.size(), "photo") + " with a camera position from " +
      scan.model.source + "; " + std::to_string(compared) + " matched, in " +
      format_count(scan.cloud.pairs.size(), "pair") + ", which gave " +
      format_count(scan.cloud.points.size(), "point") + ".");
  if (!notes.empty()) html += format_note_box("Photos", notes);
  html += "<div class=\"plan\">" + ring_plan(evidence, surface, ring.block_centre) + "</div>\n" +
          photo_table(ring, unit) + "<h3>Coverage of the surface</h3>\n" +
          coverage_map(evidence, surface, scan.metric) + scale_part(scan, evidence, unit);
  return format_section("Photographs", html);
}

}  // namespace clast
