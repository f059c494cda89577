#include "report/blocks/turntable.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "library/unscaled.hpp"
#include "mesh/triangle_tree.hpp"
#include "mesh/weld.hpp"
#include "report/blocks/block_pictures.hpp"
#include "report/charts/palette.hpp"
#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"
#include "report/html/packed_numbers.hpp"
#include "report/html/page_script.hpp"
#include "report/scene/three_library.hpp"

namespace clast::report_detail {
namespace {

using Json = nlohmann::ordered_json;

/// Corners that look as round as finer ones.
constexpr int kTurntableSkinSegments = 2;
constexpr double kMaxPieces = 200.0;  // of a side, in a byte
constexpr double kSteps = 32767.0, kShareSteps = 127.0;

/// The mesh, or one of at most so many triangles whose vertices are some of its own.
TriangleMesh coarser(const TriangleMesh& mesh, std::size_t maximum) {
  if (mesh.triangles.size() <= maximum) return mesh;
  constexpr double kFirst = 1.2, kGrowth = 1.15;
  double distance = kFirst * std::sqrt(surface_area(mesh) / static_cast<double>(maximum));
  TriangleMesh joined = weld_vertices(mesh, distance);
  while (joined.triangles.size() > maximum) joined = weld_vertices(mesh, distance *= kGrowth);
  return joined;
}

Json turntable_mesh_json(const TriangleMesh& mesh, const Vec3& centre, double size,
                         const UnobservedPlaces& unobserved) {
  std::vector<std::int16_t> vertices;
  for (const Vec3& vertex : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      vertices.push_back(static_cast<std::int16_t>(
          std::lround(kSteps * std::clamp((vertex - centre)[axis] / size, -1.0, 1.0))));
    }
  }
  std::vector<std::uint32_t> corners;
  std::vector<std::uint8_t> is_unobserved;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    corners.insert(corners.end(), t.begin(), t.end());
    if (!unobserved) continue;
    const Vec3 middle = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    is_unobserved.push_back(unobserved(middle) ? 1 : 0);
  }
  Json json = {{"vertices", encode_packed_array<std::int16_t>(vertices)},
               {"triangles", encode_packed_array<std::uint32_t>(corners)}};
  if (std::find(is_unobserved.begin(), is_unobserved.end(), 1) != is_unobserved.end()) {
    json["unobserved"] = encode_packed_array<std::uint8_t>(is_unobserved);
  }
  return json;
}

/// Distances of a shape from the surface that it replaces, also between corners of its triangles.
Json deviation_json(const TurntableContents& contents, double step) {
  const TriangleMesh& skin = contents.shape;
  std::vector<std::uint8_t> pieces;
  std::vector<std::int8_t> shares;
  for (const TriangleMesh::Triangle& triangle : skin.triangles) {
    const Vec3 &a = skin.vertices[triangle[0]], &b = skin.vertices[triangle[1]],
               &c = skin.vertices[triangle[2]];
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int n = static_cast<int>(std::clamp(std::ceil(longest / step), 1.0, kMaxPieces));
    pieces.push_back(static_cast<std::uint8_t>(n));
    for (int row = 0; row <= n; ++row) {
      for (int column = 0; column <= row; ++column) {
        const Vec3 place = a + (b - a) * (static_cast<double>(row - column) / n) +
                           (c - a) * (static_cast<double>(column) / n);
        const double share = std::clamp(contents.distance(place) / contents.reach, -1.0, 1.0);
        shares.push_back(static_cast<std::int8_t>(std::lround(kShareSteps * share)));
      }
    }
  }
  Json colours = Json::array();
  for (const Rgb& colour : kDeviationColours) colours.push_back(format_colour(colour));
  return {{"reach", contents.reach},
          {"colours", colours},
          {"pieces", encode_packed_array<std::uint8_t>(pieces)},
          {"shares", encode_packed_array<std::int8_t>(shares)}};
}

Json turntable_vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

void TurntableLimits::check() const {
  if (scan_triangles < 100) {
    throw InputError("scan_triangles = " + std::to_string(scan_triangles) +
                     ": must be 100 or more");
  }
  if (!(deviation_cells >= 1.0 && deviation_cells <= kMaxPieces)) {
    throw InputError("deviation_cells = " + format_significant(deviation_cells, 6) +
                     ": must be 1 to 200");
  }
}

std::string format_turntable_json(const TurntableContents& contents, const TurntableLimits& limits,
                                  const UnobservedPlaces& unobserved) {
  limits.check();
  const TriangleMesh scan = coarser(contents.surface, limits.scan_triangles);
  const Vec3 centre = contents.box.centre;
  double size = 0.0;
  for (const TriangleMesh* mesh : {&contents.shape, &scan}) {
    for (const Vec3& vertex : mesh->vertices) size = std::max(size, (vertex - centre).norm());
  }
  Json axes = Json::array();
  for (int axis = 0; axis < 3; ++axis)
    axes.push_back(turntable_vector_json(contents.box.axes.col(axis)));
  Json json = {{"name", contents.name},
               {"unit", contents.unit},
               {"size", size},
               {"centre", turntable_vector_json(centre)},
               {"block", turntable_mesh_json(contents.shape, centre, size, unobserved)},
               {"box",
                {{"centre", turntable_vector_json(centre)},
                 {"axes", axes},
                 {"lengths", turntable_vector_json(contents.box.lengths)}}}};
  if (!contents.components.empty()) {
    json["block"]["components"] = encode_packed_array<std::uint16_t>(contents.components);
  }
  if (contents.smooth) json["block"]["smooth"] = true;
  if (!scan.triangles.empty()) json["scan"] = turntable_mesh_json(scan, centre, size, unobserved);
  if (contents.distance) {
    json["deviation"] = deviation_json(contents, contents.box.lengths[0] / limits.deviation_cells);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string format_turntable_json(const Block& block, const TurntableLimits& limits,
                                  const UnobservedPlaces& unobserved) {
  TurntableContents contents = {.name = block.id,
                                .unit = is_unscaled(block) ? "units" : "m",
                                .shape = rounded_surface_mesh(block.body, kTurntableSkinSegments),
                                .surface = block.from_core ? TriangleMesh{} : block.surface,
                                .box = block.box,
                                .reach = block.deviation.hausdorff};
  std::optional<TriangleTree> tree;
  if (!contents.surface.triangles.empty() && contents.reach > 0.0) {
    tree.emplace(block.surface);
    contents.distance = [&, hint = std::uint32_t{0}](const Vec3& point) mutable {
      const TriangleTree::SignedClosest found = tree->signed_closest_point(point, hint);
      hint = found.triangle;
      return found.distance;
    };
  }
  return format_turntable_json(contents, limits, unobserved);
}

std::string format_turntable_view(const std::string& source, const TurntableChoices& choices) {
  std::string options;
  for (const auto& [value, text] : {std::pair{"block", choices.shape},
                                    {"scan", choices.surface},
                                    {"both", choices.both},
                                    {"deviation", choices.distance}}) {
    options += "<option value=\"" + std::string(value) + "\">" + escape_html(text) + "</option>\n";
  }
  return fill_template(assets::turntable_html, {{"source", source}, {"choices", options}});
}

std::string turntable_script() {
  if (!three_is_installed())
    return format_paragraph(explain_missing_three("write the pages again"));
  return format_script_element(assets::unpack_js) + three_scripts() +
         format_script_element(assets::turntable_js);
}

std::string format_turntable_section(const Block& block, const UnobservedPlaces& unobserved) {
  const std::string title = "In 3-D";
  if (!three_is_installed()) {
    return format_section(title, format_paragraph(explain_missing_three("write the pages again")));
  }
  const std::string id = "block-data";
  return format_section(
             title,
             format_paragraph(
                 "Drag to rotate, use the wheel to zoom, drag with the right button to move.") +
                 format_turntable_view(id)) +
         format_packed_element(id, format_turntable_json(block, {}, unobserved)) +
         turntable_script();
}

}  // namespace clast::report_detail
