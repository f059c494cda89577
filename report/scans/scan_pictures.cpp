#include "report/scans/scan_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/files/up_axis.hpp"
#include "core/nice_number.hpp"
#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/triangle_tree.hpp"
#include "mesh/weld.hpp"
#include "report/blocks/block_pictures.hpp"
#include "report/charts/palette.hpp"
#include "report/html/html_page.hpp"
#include "report/scans/unobserved_surface.hpp"

namespace clast::report_detail {

namespace {

constexpr std::uint32_t kViewWidth = 480, kViewHeight = 400;  ///< of one view, px
/// A block in a scan that is this many times larger is shown by itself too.
constexpr double kMuchLarger = 1.4;
/// Width of the surroundings of a block of a deposit, as a share of its diagonal.
constexpr double kSurroundings = 0.25;
/// Share of a cloud's points at each end of each axis that a picture may leave out.
constexpr double kStrays = 0.005;
constexpr double kMaxBar = 0.4;  ///< of a view's width

constexpr Rgb kInside{126, 142, 168};
constexpr Rgb kBorder{200, 20, 40}, kPoints{120, 108, 92};

struct Side {
  const char* name;
  Vec3 toward;
};

const std::array<Side, 3>& sides() {
  static const std::array<Side, 3> all = {{{"from the front (-y), above", default_view_direction()},
                                           {"from behind (+y), above", {-0.55, 1.0, 0.55}},
                                           {"from below", {0.45, -0.8, -1.1}}}};
  return all;
}

using Cameras = std::array<Camera, 3>;

Cameras cameras_on(std::span<const Vec3> points) {
  Cameras cameras = {make_camera(sides()[0].toward), make_camera(sides()[1].toward),
                     make_camera(sides()[2].toward)};
  frame(cameras, points, kViewWidth, kViewHeight);
  return cameras;
}

/// @param metric  false: in units of a model that nobody knows the length of
std::string length_text(double metres, bool metric) {
  if (!metric) return format_significant(metres, 3) + (metres == 1.0 ? " unit" : " units");
  if (metres >= 1.0) return format_significant(metres, 3) + " m";
  if (metres >= 0.01) return format_significant(100.0 * metres, 3) + " cm";
  return format_significant(1000.0 * metres, 3) + " mm";
}

std::string scale_bar(const Camera& camera, bool metric) {
  const double length = round_down_to_nice_number(kMaxBar * camera.width * camera.pixel);
  const double left = 14.0, y = camera.height - 14.0, right = left + length / camera.pixel;
  const char* const stroke = "stroke=\"#1d2733\" stroke-width=\"2\"";
  return format_svg_line(left, y, right, y, stroke) +
         format_svg_line(left, y - 5, left, y + 5, stroke) +
         format_svg_line(right, y - 5, right, y + 5, stroke) +
         svg_text(left + 5, y - 8, length_text(length, metric),
                  "font-size=\"15\" fill=\"#1d2733\" stroke=\"#fff\" stroke-width=\"3\" "
                  "paint-order=\"stroke\"");
}

/// One view with its name, scale bar and marks.
std::string view(const Canvas& canvas, const std::string& name,
                 const std::vector<PositionMark>& marks, bool metric) {
  const Camera& camera = canvas.camera();
  const std::string size = "width=\"" + std::to_string(camera.width) + "\" height=\"" +
                           std::to_string(camera.height) + "\"";
  std::string svg = open_svg(camera.width, camera.height, name);
  svg += "<image " + size + " href=\"" +
         png_data_uri(encode_rgb_png(camera.width, camera.height, canvas.picture())) + "\"/>";
  for (const PositionMark& mark : marks) {
    if (!canvas.is_visible(mark.position)) continue;
    const Vec3 at = camera.projected(mark.position);
    svg += "<circle cx=\"" + format_fixed(at.x(), 1) + "\" cy=\"" + format_fixed(at.y(), 1) +
           "\" r=\"10\" fill=\"#fff\" fill-opacity=\".85\" stroke=\"#0072B2\" "
           "stroke-width=\"2\"/>" +
           svg_text(at.x(), at.y() + 4.5, mark.label,
                    "font-size=\"12\" font-weight=\"600\" text-anchor=\"middle\" "
                    "fill=\"#0072B2\"");
  }
  return svg + scale_bar(camera, metric) +
         svg_text(14, 22, name,
                  "font-size=\"15\" fill=\"#5b6775\" stroke=\"#fff\" stroke-width=\"3\" "
                  "paint-order=\"stroke\"") +
         "</svg>";
}

template <class Draw>
std::string three_views(const Cameras& cameras, const Draw& draw, const std::string& caption,
                        bool metric, const std::vector<PositionMark>& marks = {}) {
  std::string html = "<figure><div class=\"views\">";
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    Canvas canvas(cameras[i]);
    draw(canvas);
    html += "<div>" + view(canvas, sides()[i].name, marks, metric) + "</div>";
  }
  return html + "</div><figcaption>" + escape_html(caption) + "</figcaption></figure>\n";
}

std::vector<std::array<Vec3, 2>> border_of(const TriangleMesh& mesh) {
  std::vector<std::array<Vec3, 2>> lines;
  const auto sides = sorted_half_edges(mesh);
  for_each_edge(sides, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1)
      lines.push_back({mesh.vertices[edge[0].low], mesh.vertices[edge[0].high]});
  });
  return lines;
}

/// The points without what lies far off: what a picture is framed by.
std::vector<Vec3> without_strays(const std::vector<Vec3>& points) {
  Bounds box;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> sorted;
    for (const Vec3& p : points) sorted.push_back(p[axis]);
    const auto cut = static_cast<std::size_t>(kStrays * static_cast<double>(sorted.size()));
    const auto low = sorted.begin() + static_cast<std::ptrdiff_t>(cut);
    const auto high = sorted.end() - 1 - static_cast<std::ptrdiff_t>(cut);
    std::nth_element(sorted.begin(), low, sorted.end());
    box.low[axis] = *low;
    std::nth_element(sorted.begin(), high, sorted.end());
    box.high[axis] = *high;
  }
  const Vec3 margin = 0.1 * (box.high - box.low);
  std::vector<Vec3> kept;
  for (const Vec3& p : points) {
    if ((p - box.low + margin).minCoeff() >= 0.0 && (box.high + margin - p).minCoeff() >= 0.0) {
      kept.push_back(p);
    }
  }
  return kept;
}

/// Scan in the frame of a block. For a block of a deposit, it is the points around the block.
TriangleMesh scan_around(const TriangleMesh& raw, const FieldBlock& block,
                         const std::function<Vec3(const Vec3&)>& to_block) {
  TriangleMesh read;
  if (!block.in_deposit) {
    read = raw;
    for (Vec3& v : read.vertices) v = to_block(v);
    return read;
  }
  const Bounds box = bounds(block.scan.mesh);
  const Vec3 margin = Vec3::Constant(kSurroundings * box.diagonal());
  for (const Vec3& vertex : raw.vertices) {
    const Vec3 p = to_block(vertex);
    if ((p - box.low + margin).minCoeff() >= 0.0 && (box.high + margin - p).minCoeff() >= 0.0) {
      read.vertices.push_back(p);
    }
  }
  return read;
}

std::string colour_bar(double reach, bool metric) {
  constexpr int kPieces = 64;
  constexpr double kLeft = 40.0, kLength = 360.0, kThick = 14.0;
  std::string svg = open_svg(440, 44, "colour scale of distances");
  for (int i = 0; i < kPieces; ++i) {
    const std::string colour = format_colour(deviation_colour(2.0 * (i + 0.5) / kPieces - 1.0));
    svg += "<rect x=\"" + format_fixed(kLeft + i * kLength / kPieces, 2) + "\" y=\"2\" width=\"" +
           format_fixed(kLength / kPieces + 0.3, 2) + "\" height=\"" + format_fixed(kThick, 0) +
           "\" fill=\"" + colour + "\"/>";
  }
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const double x = kLeft + 0.5 * (share + 1.0) * kLength;
    std::string text = share == 0.0 ? "0" : length_text(std::abs(share) * reach, metric);
    if (share < 0.0) text = "\xE2\x88\x92" + text;
    svg +=
        format_svg_line(x, 2 + kThick, x, 6 + kThick, "stroke=\"#5b6775\"") +
        svg_text(x, 20 + kThick, text, "font-size=\"12\" text-anchor=\"middle\" fill=\"#33404d\"");
  }
  return "<div class=\"colours\">" + svg + "</svg></div>\n";
}

}  // namespace

std::string draw_before_and_after(const TriangleMesh& raw, const ScanOptions& options,
                                  const FieldBlock& block, const std::vector<PositionMark>& marks,
                                  bool metric) {
  const auto to_block = [&](const Vec3& point) -> Vec3 {
    Vec3 p = options.unit * point;
    if (options.up == "y") p = y_up_to_z_up(p);
    return block.block_from_file * p;
  };
  const bool of_deposit = block.in_deposit.has_value();
  TriangleMesh read = scan_around(raw, block, to_block);
  std::vector<PositionMark> placed = marks;
  for (PositionMark& mark : placed) mark.position = to_block(mark.position);
  const bool cloud = read.triangles.empty();
  if (!cloud) read = weld_vertices(read, options.repair.weld_tolerance * bounds(read).diagonal());

  const std::vector<std::array<Vec3, 2>> border = border_of(read);
  const auto draw_read = [&](Canvas& canvas) {
    if (cloud) return canvas.draw(read.vertices, kPoints);
    canvas.draw(read, [](std::uint32_t, const Vec3&, bool behind) {
      return behind ? kInside : kBlockColour;
    });
    canvas.draw(border, kBorder);
  };
  const std::string colours =
      cloud ? "Nearer points are darker."
            : "Blue-grey: inside of the surface, visible through holes. Red: open borders.";
  const std::string numbers =
      placed.empty() ? "" : " Numbers: positions of the defects in the tables below.";

  const std::vector<Vec3> framed = without_strays(read.vertices);
  const Cameras wide = cameras_on(framed), near = cameras_on(block.scan.mesh.vertices);
  std::string html;
  if (!of_deposit) {
    html += three_views(wide, draw_read, "The scan as it was read. " + colours + numbers, metric,
                        placed);
  }
  if (of_deposit || wide[0].pixel > kMuchLarger * near[0].pixel) {
    html +=
        three_views(near, draw_read, "The part of the scan around the block. " + colours + numbers,
                    metric, placed);
  }
  UnobservedSurface unobserved(block, read);
  html += three_views(
      near,
      [&](Canvas& canvas) {
        canvas.draw(block.scan.mesh, [&](std::uint32_t t, const Vec3&, bool) {
          return unobserved.contains(t) ? kUnobservedColour : kBlockColour;
        });
      },
      of_deposit
          ? "The closed body. Orange: its estimated side, which the scan does not show."
          : "The closed and repaired scan. Orange: surface that was not scanned but filled, "
            "or moved by more than " +
                length_text(kNewSurfaceDistance * bounds(block.scan.mesh).diagonal(), metric) + ".",
      metric);
  return format_section("Before and after", html);
}

std::string draw_deviation_map(const TriangleMesh& skin, const TriangleMesh& scan, double reach,
                               bool metric) {
  const TriangleTree tree(scan);
  std::uint32_t hint = 0;
  return three_views(
             cameras_on(scan.vertices),
             [&](Canvas& canvas) {
               canvas.draw(
                   skin,
                   [&](std::uint32_t, const Vec3& place, bool) {
                     const auto closest = tree.signed_closest_point(place, hint);
                     hint = closest.triangle;
                     return deviation_colour(closest.distance / reach);
                   },
                   0.7);
             },
             "The block, coloured by how far its surface lies outside (red) or inside (blue) the "
             "closed scan.",
             metric) +
         colour_bar(reach, metric);
}

std::string draw_join_map(const TriangleMesh& block, const std::vector<double>& distances,
                          double reach) {
  return draw_coloured_views(
             block,
             [&](std::uint32_t t) {
               double sum = 0.0;
               for (const std::uint32_t v : block.triangles[t]) sum += distances[v] / 3.0;
               return std::isfinite(sum) ? deviation_colour(sum / reach) : kInside;
             },
             "The block, coloured by the distance between the surfaces of the joined scans (red: "
             "far apart). Blue-grey: shown by one scan alone.") +
         colour_bar(reach, true);
}

std::string draw_coloured_views(const TriangleMesh& mesh,
                                const std::function<Rgb(std::uint32_t)>& colour,
                                const std::string& caption, bool metric) {
  return three_views(
      cameras_on(mesh.vertices),
      [&](Canvas& canvas) {
        canvas.draw(
            mesh, [&](std::uint32_t t, const Vec3&, bool) { return colour(t); }, 0.7);
      },
      caption, metric);
}

}  // namespace clast::report_detail
