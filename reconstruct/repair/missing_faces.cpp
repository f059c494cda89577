#include "reconstruct/repair/missing_faces.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/disjoint_sets.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/triangle_geometry.hpp"
#include "reconstruct/repair/detail/loop_filling.hpp"
#include "reconstruct/repair/hole_loops.hpp"
#include "reconstruct/repair/holes.hpp"

namespace clast::reconstruct_detail {

namespace {

/// The search of a filling is cubic in the corners.
constexpr std::size_t kMaxHoleCorners = 150;
/// Components with less of the area that touch the rest nowhere are not closed here.
constexpr double kLooseComponent = 0.05;

/// Marks vertices of components, connected over vertices, with enough area.
std::vector<bool> on_large_component(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  std::vector<double> area(mesh.vertices.size(), 0.0);
  double whole = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const double here = triangle_area(mesh, t);
    area[sets.find(t[0])] += here;
    whole += here;
  }
  std::vector<bool> large(mesh.vertices.size());
  for (std::uint32_t v = 0; v < large.size(); ++v) {
    large[v] = area[sets.find(v)] > kLooseComponent * whole;
  }
  return large;
}

}  // namespace

std::vector<FilledHole> retriangulate_missing_faces(TriangleMesh& mesh) {
  std::vector<FilledHole> filled;
  const std::vector<std::vector<std::uint32_t>> loops = find_hole_loops(mesh);
  if (loops.empty()) return filled;
  const std::vector<bool> large = on_large_component(mesh);
  std::set<EdgeKey> edges;
  std::map<EdgeKey, Vec3> beyond;  // normals beside border sides
  for_each_edge(sorted_half_edges(mesh), [&](std::span<const HalfEdge> sides) {
    edges.insert(edges.end(), {sides[0].low, sides[0].high});
    if (sides.size() != 1) return;
    const TriangleMesh::Triangle& t = mesh.triangles[sides[0].triangle];
    beyond[{sides[0].low, sides[0].high}] = doubled_area_vector(mesh, t).normalized();
  });
  for (const std::vector<std::uint32_t>& loop : loops) {
    if (loop.size() < 3 || loop.size() > kMaxHoleCorners || !large[loop[0]]) continue;
    std::vector<Vec3> border, normals;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      border.push_back(mesh.vertices[loop[i]]);
      normals.push_back(beyond.at(make_edge_key(loop[i], loop[(i + 1) % loop.size()])));
    }
    const std::optional<LoopFilling> filling = triangulate_loop(mesh, loop, normals, edges);
    if (!filling) continue;
    FilledHole hole = measure_hole(border);
    const double width = 2.0 * filling->area / hole.perimeter;
    const double side = hole.perimeter / static_cast<double>(loop.size());
    if (width > kMaxMissingFaceWidth * side) continue;
    for (const TriangleMesh::Triangle& t : filling->triangles) {
      for (std::size_t k = 0; k < 3; ++k) edges.insert(make_edge_key(t[k], t[(k + 1) % 3]));
      mesh.triangles.push_back(t);
    }
    hole.area = filling->area;
    hole.volume_below = filling->volume_below;
    hole.volume_above = filling->volume_above;
    hole.is_fan = true;
    filled.push_back(hole);
  }
  return filled;
}

}  // namespace clast::reconstruct_detail
