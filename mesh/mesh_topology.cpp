#include "mesh/mesh_topology.hpp"

#include <algorithm>
#include <limits>

#include "core/comma_separated.hpp"
#include "core/disjoint_sets.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"

namespace clast {

namespace {

/// Height over longest side below which a triangle has no area: rounding of its coordinates.
constexpr double kFlatTriangle = 1e-12;

void check_indices(const TriangleMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t vertex : mesh.triangles[t]) {
      if (vertex < mesh.vertices.size()) continue;
      throw GeometryError("triangle " + std::to_string(t + 1) + " refers to vertex " +
                          std::to_string(std::uint64_t{vertex} + 1) + " of " +
                          std::to_string(mesh.vertices.size()) + "; the mesh is corrupt");
    }
  }
}

bool has_area(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() > kFlatTriangle * longest;
}

/// Boundary half-edges turned round, sorted by where they start.
std::vector<std::array<std::uint32_t, 2>> open_sides(std::span<const HalfEdge> sorted) {
  std::vector<std::array<std::uint32_t, 2>> sides;
  for_each_edge(sorted, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 1) sides.push_back({edge[0].to(), edge[0].from()});
  });
  std::sort(sides.begin(), sides.end());
  return sides;
}

std::vector<std::vector<std::uint32_t>> loops_of(std::span<const HalfEdge> sorted) {
  const std::vector<std::array<std::uint32_t, 2>> sides = open_sides(sorted);
  std::vector<bool> used(sides.size(), false);
  const auto next_from = [&](std::uint32_t vertex) {
    auto side =
        std::lower_bound(sides.begin(), sides.end(), std::array<std::uint32_t, 2>{vertex, 0});
    while (side != sides.end() && (*side)[0] == vertex &&
           used[static_cast<std::size_t>(side - sides.begin())]) {
      ++side;
    }
    return side != sides.end() && (*side)[0] == vertex
               ? static_cast<std::size_t>(side - sides.begin())
               : sides.size();
  };

  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<std::uint32_t> position(sides.empty() ? 0 : sides.back()[0] + 1, kNoIndex);
  for (std::size_t start = 0; start < sides.size(); ++start) {
    if (used[start]) continue;
    std::vector<std::uint32_t> path = {sides[start][0]};
    position[path[0]] = 0;
    while (!path.empty()) {
      const std::size_t side = next_from(path.back());
      if (side == sides.size()) {  // a dead end: neighbours disagree in orientation here
        position[path.back()] = kNoIndex;
        path.pop_back();
        continue;
      }
      used[side] = true;
      const std::uint32_t vertex = sides[side][1];
      if (vertex >= position.size()) continue;  // nothing open starts there
      if (position[vertex] == kNoIndex) {
        position[vertex] = static_cast<std::uint32_t>(path.size());
        path.push_back(vertex);
        continue;
      }
      const auto first = path.begin() + position[vertex];
      loops.emplace_back(first, path.end());
      for (auto v = first + 1; v != path.end(); ++v) position[*v] = kNoIndex;
      path.erase(first + 1, path.end());
    }
  }
  return loops;
}

}  // namespace

std::string MeshReport::summary() const {
  if (triangles == 0) return "no triangles";
  std::vector<std::string> defects;
  if (boundary_edges > 0) {
    defects.push_back(format_count(boundary_edges, "boundary edge", "boundary edges") + " in " +
                      format_count(boundary_loops, "loop", "loops"));
  }
  if (non_manifold_edges > 0) {
    defects.push_back(format_count(non_manifold_edges, "non-manifold edge", "non-manifold edges"));
  }
  if (misoriented_edges > 0) {
    defects.push_back(format_count(misoriented_edges, "misoriented edge", "misoriented edges"));
  }
  if (pinched_vertices > 0) {
    defects.push_back(format_count(pinched_vertices, "pinched vertex", "pinched vertices"));
  }
  if (degenerate_triangles > 0) {
    defects.push_back(
        format_count(degenerate_triangles, "degenerate triangle", "degenerate triangles"));
  }
  if (components > 1) defects.push_back(std::to_string(components) + " components");
  return defects.empty() ? "closed" : comma_separated(defects);
}

MeshReport inspect_mesh(const TriangleMesh& mesh) {
  check_indices(mesh);
  MeshReport report;
  report.vertices = mesh.vertices.size();
  report.triangles = mesh.triangles.size();
  std::size_t faces = 0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    if (!has_repeated_vertex(t)) ++faces;
    if (has_repeated_vertex(t) || !has_area(mesh, t)) ++report.degenerate_triangles;
  }

  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    ++report.edges;
    if (sides.size() == 1) ++report.boundary_edges;
    if (sides.size() > 2) ++report.non_manifold_edges;
    if (sides.size() == 2 && sides[0].is_forward == sides[1].is_forward) ++report.misoriented_edges;
  });
  report.boundary_loops = loops_of(sorted).size();

  const std::vector<std::uint32_t> fans = corner_fans(mesh, sorted);
  std::vector<std::uint32_t> fans_at(mesh.vertices.size(), 0);
  for (std::uint32_t c = 0; c < fans.size(); ++c) {
    const TriangleMesh::Triangle& t = mesh.triangles[c / 3];
    if (fans[c] == c && !has_repeated_vertex(t)) ++fans_at[t[c % 3]];
  }
  std::size_t used = 0;
  for (const std::uint32_t count : fans_at) {
    if (count > 0) ++used;
    if (count > 1) ++report.pinched_vertices;
  }
  report.euler_characteristic =
      static_cast<long>(used) - static_cast<long>(report.edges) + static_cast<long>(faces);
  const std::vector<std::uint32_t> components = triangle_components(mesh);
  std::vector<bool> seen(mesh.triangles.size(), false);
  for (std::size_t t = 0; t < components.size(); ++t) {
    if (has_repeated_vertex(mesh.triangles[t]) || seen[components[t]]) continue;
    seen[components[t]] = true;
    ++report.components;
  }
  return report;
}

std::vector<std::uint32_t> triangle_components(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.triangles.size());
  const std::vector<HalfEdge> sorted = sorted_half_edges(mesh);
  for_each_edge(sorted, [&](std::span<const HalfEdge> sides) {
    for (std::size_t i = 1; i < sides.size(); ++i) sets.join(sides[0].triangle, sides[i].triangle);
  });
  std::vector<std::uint32_t> number(mesh.triangles.size(), kNoIndex), result;
  result.reserve(mesh.triangles.size());
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& component = number[sets.find(t)];
    if (component == kNoIndex) component = count++;
    result.push_back(component);
  }
  return result;
}

std::vector<std::vector<std::uint32_t>> boundary_loops(const TriangleMesh& mesh) {
  check_indices(mesh);
  return loops_of(sorted_half_edges(mesh));
}

}  // namespace clast
