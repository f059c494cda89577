#include "mesh/edge_collapse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mesh/half_edges.hpp"
#include "mesh/plane_quadric.hpp"
#include "mesh/sub_mesh.hpp"
#include "mesh/triangle_geometry.hpp"
#include "mesh/vertex_corners.hpp"

namespace clast {

namespace {

using Triangle = TriangleMesh::Triangle;
using Indices = std::vector<std::uint32_t>;

/// Cosine between a face's normals before and after a collapse below which it counts as folded.
constexpr double kFold = 0.2;
/// A meeting point farther from the edge's middle than this many edge lengths is not trusted.
constexpr double kFarthest = 1.5;

/// Rings of neighbours that are tried if a triangle cannot be collapsed.
constexpr int kRings = 3;

bool has_corner(const Triangle& t, std::uint32_t vertex) {
  return t[0] == vertex || t[1] == vertex || t[2] == vertex;
}

class Collapser {
 public:
  explicit Collapser(TriangleMesh& mesh)
      : mesh_(mesh), corners_(mesh), locked_(mesh.vertices.size(), false) {}

  bool collapse_shortest(std::uint32_t triangle) {
    const Triangle& t = mesh_.triangles[triangle];
    std::array<std::size_t, 3> order = {0, 1, 2};
    const auto length = [&](std::size_t k) {
      return (mesh_.vertices[t[(k + 1) % 3]] - mesh_.vertices[t[k]]).squaredNorm();
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return length(a) < length(b); });
    for (const std::size_t k : order) {
      if (collapse(t[k], t[(k + 1) % 3])) return true;
    }
    return false;
  }

  void compact() {
    std::erase_if(mesh_.triangles, has_repeated_vertex);
    remove_unused_vertices(mesh_);
  }

 private:
  Indices neighbours(std::uint32_t vertex) const {
    Indices ring;
    for (const std::uint32_t corner : corners_.corners_of(vertex)) {
      for (const std::uint32_t v : mesh_.triangles[corner / 3]) {
        if (v != vertex) ring.push_back(v);
      }
    }
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    return ring;
  }

  Vec3 meeting_point(std::uint32_t u, std::uint32_t v) const {
    const Vec3 middle = 0.5 * (mesh_.vertices[u] + mesh_.vertices[v]);
    PlaneQuadric fit;
    for (const std::uint32_t vertex : {u, v}) {
      for (const std::uint32_t corner : corners_.corners_of(vertex)) {
        const Triangle& t = mesh_.triangles[corner / 3];
        const Vec3 normal = unit_normal(mesh_, t);
        fit.add_plane(normal, normal.dot(mesh_.vertices[vertex] - middle),
                      corner_angle(mesh_, t, corner % 3));
      }
    }
    const Vec3 step = fit.step_to_intersection();
    const double longest = kFarthest * (mesh_.vertices[u] - mesh_.vertices[v]).norm();
    return step.norm() < longest ? Vec3(middle + step) : middle;
  }

  /// True if moving `from` to `point` inverts a triangle that keeps its area.
  bool folds(std::uint32_t from, std::uint32_t other, const Vec3& point) const {
    for (const std::uint32_t corner : corners_.corners_of(from)) {
      const Triangle& corners = mesh_.triangles[corner / 3];
      if (has_corner(corners, other)) continue;
      std::array<Vec3, 3> points;
      for (std::size_t k = 0; k < 3; ++k) {
        points[k] = corners[k] == from ? point : mesh_.vertices[corners[k]];
      }
      const Vec3 after = (points[1] - points[0]).cross(points[2] - points[0]);
      const Vec3 before = unit_normal(mesh_, corners);
      if (before.isZero()) continue;
      if (!(after.dot(before) > kFold * after.norm())) return true;
    }
    return false;
  }

  bool collapse(std::uint32_t u, std::uint32_t v) {
    if (locked_[u] || locked_[v]) return false;
    const Indices ring_u = neighbours(u), ring_v = neighbours(v);
    Indices shared;
    std::set_intersection(ring_u.begin(), ring_u.end(), ring_v.begin(), ring_v.end(),
                          std::back_inserter(shared));
    // Only then the surface stays a manifold; a vertex of three triangles would fold them flat.
    if (shared.size() != 2 || locked_[shared[0]] || locked_[shared[1]]) return false;
    if (corners_.corners_of(shared[0]).size() < 4 || corners_.corners_of(shared[1]).size() < 4)
      return false;
    const Vec3 point = meeting_point(u, v);
    if (folds(u, v, point) || folds(v, u, point)) return false;
    for (const Indices* ring : {&ring_u, &ring_v}) {
      for (const std::uint32_t vertex : *ring) locked_[vertex] = true;
    }
    mesh_.vertices[u] = point;
    for (const std::uint32_t corner : corners_.corners_of(v)) {
      mesh_.triangles[corner / 3][corner % 3] = u;
    }
    return true;
  }

  TriangleMesh& mesh_;
  VertexCorners corners_;  ///< stale only where locked
  std::vector<bool> locked_;
};

/// The triangles and all that touch them.
Indices widened(const TriangleMesh& mesh, const Indices& triangles) {
  std::vector<bool> touched(mesh.vertices.size(), false);
  for (const std::uint32_t t : triangles) {
    for (const std::uint32_t v : mesh.triangles[t]) touched[v] = true;
  }
  Indices result;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (touched[a] || touched[b] || touched[c]) result.push_back(t);
  }
  return result;
}

}  // namespace

std::size_t collapse_triangle_edges(TriangleMesh& mesh, std::span<const std::uint32_t> triangles) {
  Indices tried(triangles.begin(), triangles.end());
  for (int ring = 0; ring <= kRings; ++ring) {
    Collapser collapser(mesh);
    std::size_t count = 0;
    for (const std::uint32_t triangle : tried) {
      // Vertices of an earlier collapse are locked: a changed triangle is left for the next call.
      if (!has_repeated_vertex(mesh.triangles[triangle]) && collapser.collapse_shortest(triangle))
        ++count;
    }
    if (count > 0) {
      collapser.compact();
      return count;
    }
    tried = widened(mesh, tried);
  }
  return 0;
}

}  // namespace clast
