#include "reconstruct/repair/components.hpp"

#include <algorithm>
#include <cmath>

#include "core/types.hpp"
#include "mesh/mesh_topology.hpp"

namespace clast::reconstruct_detail {

namespace {

/// Share of the diagonal within which a bubble touches the skin and doesn't pierce it.
constexpr double kTouching = 1e-6;

}  // namespace

std::vector<SurfaceComponent> connected_components(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> number_of = triangle_components(mesh);
  std::vector<std::vector<TriangleMesh::Triangle>> groups;
  for (std::size_t t = 0; t < number_of.size(); ++t) {
    if (number_of[t] >= groups.size()) groups.resize(number_of[t] + 1);
    groups[number_of[t]].push_back(mesh.triangles[t]);
  }
  std::vector<SurfaceComponent> components;
  if (groups.size() == 1) {
    components.push_back({mesh, surface_area(mesh)});
    return components;
  }
  // One table of numbers for all components: a soup may have as many as triangles.
  std::vector<std::uint32_t> new_index(mesh.vertices.size());
  std::vector<std::size_t> stamp(mesh.vertices.size(), groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    SurfaceComponent component;
    std::vector<std::uint32_t> used;
    for (const TriangleMesh::Triangle& t : groups[g]) {
      for (const std::uint32_t v : t) {
        if (stamp[v] == g) continue;
        stamp[v] = g;
        used.push_back(v);
      }
    }
    std::sort(used.begin(), used.end());
    for (const std::uint32_t v : used) {
      new_index[v] = static_cast<std::uint32_t>(component.mesh.vertices.size());
      component.mesh.vertices.push_back(mesh.vertices[v]);
    }
    for (const TriangleMesh::Triangle& t : groups[g]) {
      component.mesh.triangles.push_back({new_index[t[0]], new_index[t[1]], new_index[t[2]]});
    }
    component.area = surface_area(component.mesh);
    components.push_back(std::move(component));
  }
  std::stable_sort(
      components.begin(), components.end(),
      [](const SurfaceComponent& a, const SurfaceComponent& b) { return a.area > b.area; });
  return components;
}

bool encloses(const TriangleMesh& closed, const Vec3& point) {
  const Bounds box = bounds(closed);
  if ((point.array() < box.low.array()).any() || (point.array() > box.high.array()).any()) {
    return false;
  }
  // Solid angle of every triangle (Van Oosterom & Strackee 1983).
  double half_angles = 0.0;
  for (const TriangleMesh::Triangle& t : closed.triangles) {
    const Vec3 a = closed.vertices[t[0]] - point, b = closed.vertices[t[1]] - point,
               c = closed.vertices[t[2]] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    half_angles +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return std::abs(half_angles) > kPi;
}

bool is_inside_block(const TriangleMesh& component, const TriangleMesh& block,
                     const TriangleTree& tree) {
  // The winding number means nothing on the surface itself, so the point farthest from it is asked.
  Vec3 farthest = component.vertices[0];
  double distance = -1.0;
  const auto ask = [&](const Vec3& point) {
    const double squared = tree.closest_point(point).squared_distance;
    if (squared <= distance) return;
    distance = squared;
    farthest = point;
  };
  for (const Vec3& vertex : component.vertices) ask(vertex);
  for (const auto& [a, b, c] : component.triangles) {
    ask((component.vertices[a] + component.vertices[b] + component.vertices[c]) / 3.0);
  }
  if (!encloses(block, farthest)) return false;
  // The block may still face inwards, so only sides that differ mean something.
  const double side = tree.signed_distance(farthest) < 0.0 ? -1.0 : 1.0;
  const double touching = -kTouching * bounds(block).diagonal();
  return std::all_of(component.vertices.begin(), component.vertices.end(), [&](const Vec3& vertex) {
    return side * tree.signed_distance(vertex) > touching;
  });
}

bool is_on_surface(const TriangleMesh& component, const TriangleTree& tree, double distance) {
  std::uint32_t hint = 0;
  return std::all_of(component.vertices.begin(), component.vertices.end(), [&](const Vec3& vertex) {
    const TriangleTree::Closest found = tree.closest_point(vertex, hint);
    hint = found.triangle;
    return found.squared_distance <= distance * distance;
  });
}

}  // namespace clast::reconstruct_detail
