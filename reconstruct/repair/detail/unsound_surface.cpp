#include "reconstruct/repair/detail/unsound_surface.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_topology.hpp"
#include "mesh/triangle_neighbours.hpp"
#include "reconstruct/repair/repair.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Volume over diagonal cubed below which a surface encloses nothing: a folded sheet.
constexpr double kNoVolume = 1e-9;
constexpr std::size_t kHolesNamed = 3;
/// A grain of sand is a million times larger; squares of what is much smaller are no numbers, and
/// exact arithmetic with it takes minutes.
constexpr double kMinExtent = 1e-9;  // m

/// "88 open edges in 9 holes: 30 edges and 0.41 m round near (...), ..."
std::string open_edges(TriangleMesh mesh, const RepairLog& log) {
  orient_consistently(mesh);  // or the borders would not chain into holes
  const std::size_t open = inspect_mesh(mesh).boundary_edges;
  if (open == 0) return "";
  std::string text = format_count(open, "open edge", "open edges");
  std::vector<std::vector<std::uint32_t>> loops = boundary_loops(mesh);
  if (loops.empty()) return text;
  text += " in " + format_count(loops.size(), "hole", "holes");
  std::stable_sort(loops.begin(), loops.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  const std::size_t named = std::min(kHolesNamed, loops.size());
  for (std::size_t i = 0; i < named; ++i) {
    double around = 0.0;
    for (std::size_t k = 0; k < loops[i].size(); ++k) {
      around +=
          (mesh.vertices[loops[i][(k + 1) % loops[i].size()]] - mesh.vertices[loops[i][k]]).norm();
    }
    text += (i == 0 ? ": " : ", ") + format_count(loops[i].size(), "edge", "edges") + " and " +
            format_significant(around, 3) + " m in perimeter near " +
            log.format_position(mesh.vertices[loops[i].front()]);
  }
  return text + (named < loops.size() ? ", and smaller ones" : "");
}

}  // namespace

void check_coordinates(const TriangleMesh& mesh) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!mesh.vertices[v].allFinite()) {
      throw GeometryError("vertex " + std::to_string(v + 1) +
                          " is not a finite point; correct the file in the program that wrote it");
    }
    const double farthest = mesh.vertices[v].cwiseAbs().maxCoeff();
    if (farthest > kMaxCoordinate) {
      throw GeometryError("vertex " + std::to_string(v + 1) + " lies " +
                          format_significant(farthest, 3) +
                          " m from the origin: the file is damaged, or its unit is wrong; check "
                          "the unit it was read in");
    }
  }
  check_extent(mesh);
}

void check_extent(const TriangleMesh& mesh) {
  const double diagonal = bounds(mesh).diagonal();
  if (mesh.vertices.empty() || diagonal >= kMinExtent) return;
  throw GeometryError("the mesh is " + format_significant(diagonal, 3) +
                      " m across: the file is damaged, or its unit is wrong; check the unit it "
                      "was read in");
}

void check_not_empty(const TriangleMesh& mesh) {
  if (!mesh.triangles.empty()) return;
  throw GeometryError("no surface is left: its triangles have no area or cancel each other");
}

void check_orientable(const TriangleMesh& mesh, const OrientationResult& facing,
                      const RepairLog& log) {
  if (facing.orientable) return;
  throw GeometryError("the surface is non-orientable near " +
                      log.format_position(mesh.vertices[facing.conflict_vertex]) +
                      " (inside and outside can't be distinguished)" + kRepairAdvice);
}

void check_hole_size(const FilledHole& hole, double largest, const TriangleMesh& welded,
                     const RepairLog& log) {
  if (hole.area_fraction <= largest || hole.is_fan) return;
  throw GeometryError(
      "the surface is an open sheet, not a block: " + open_edges(welded, log) +
      "; filling would make up " + format_significant(100.0 * hole.area_fraction, 3) +
      " % of its surface. For a piece of ground use clast terrain; for a block scan more sides");
}

void check_closed(const TriangleMesh& mesh, const TriangleMesh& welded, const RepairLog& log) {
  if (inspect_mesh(mesh).is_closed()) return;
  std::string text = open_edges(welded, log);
  const TriangleNeighbours links = triangle_neighbours(welded);
  if (links.non_manifold_edges > 0) {
    text += text.empty() ? "" : "; ";
    text += format_count(links.non_manifold_edges, "edge", "edges") +
            " shared by more than two triangles, near " +
            log.format_position(welded.vertices[links.first_non_manifold_edge[0]]);
  }
  throw GeometryError("the surface is not closed: " + text + kRepairAdvice);
}

void check_volume(const TriangleMesh& closed) {
  const double volume = signed_volume(closed);
  if (std::abs(volume) > kNoVolume * std::pow(bounds(closed).diagonal(), 3)) return;
  throw GeometryError(
      "the surface encloses no volume, as a folded sheet; scan the block from all sides");
}

}  // namespace clast::reconstruct_detail
