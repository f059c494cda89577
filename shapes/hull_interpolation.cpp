#include "shapes/hull_interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/error.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/plane.hpp"
#include "mesh/triangle_geometry.hpp"
#include "shapes/convex_hull.hpp"
#include "shapes/star_shape.hpp"

namespace clast {
namespace {

/// Fraction of the hull's volume; a smaller gain is rounding.
constexpr double kLeastGain = 1e-12;
/// Fraction of the product of the lengths below which directions are coplanar.
constexpr double kCoplanarDirections = 1e-12;

/// The corner of the triangle that is not on the edge.
std::uint32_t across(const TriangleMesh::Triangle& t, const EdgeKey& edge) {
  for (const std::uint32_t v : t) {
    if (v != edge[0] && v != edge[1]) return v;
  }
  return t[0];
}

/// Six times the volume of the tetrahedron.
double sixfold(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

}  // namespace

HullInterpolation::HullInterpolation(const TriangleMesh& surface) : surface_(surface) {
  const std::optional<Vec3> centre = find_kernel_centroid(surface);
  if (!centre) {
    throw GeometryError(
        "the surface is not star-shaped: no inner point has a straight line of sight to all of it");
  }
  centre_ = *centre;
  const TriangleMesh hull = convex_hull(surface.vertices);
  hull_volume_ = signed_volume(hull);
  std::vector<Plane> planes;
  for (const TriangleMesh::Triangle& triangle : hull.triangles) {
    const Vec3 normal = unit_normal(hull, triangle);
    if (normal.isZero()) continue;
    planes.push_back({normal, normal.dot(hull.vertices[triangle[0]] - centre_)});
  }
  for (const Vec3& vertex : surface.vertices) {
    double reach = std::numeric_limits<double>::max();
    for (const Plane& plane : planes) {
      const double height = plane.normal.dot(vertex - centre_);
      if (height > 0.0) reach = std::min(reach, plane.distance / height);
    }
    hull_distance_.push_back(std::max(1.0, reach));
  }
  find_edge_flips();
}

TriangleMesh HullInterpolation::interpolate(double part, std::size_t edge_flips) const {
  TriangleMesh mesh = surface_;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const double factor = 1.0 + part * (hull_distance_[v] - 1.0);
    // Corners of the hull stay where they are, to the bit.
    if (factor != 1.0) mesh.vertices[v] = centre_ + factor * (mesh.vertices[v] - centre_);
  }
  for (std::size_t i = 0; i < std::min(edge_flips, edge_flips_.size()); ++i) {
    mesh.triangles[edge_flips_[i].first] = edge_flips_[i].new_first;
    mesh.triangles[edge_flips_[i].second] = edge_flips_[i].new_second;
  }
  return mesh;
}

bool HullInterpolation::flip_edge(TriangleMesh& mesh, std::uint32_t first, std::uint32_t second,
                                  const EdgeKey& edge) {
  // The first triangle runs along the edge from a to b, c is across it; d across the other.
  const TriangleMesh::Triangle& t = mesh.triangles[first];
  const std::uint32_t c = across(t, edge), d = across(mesh.triangles[second], edge);
  const auto at_c = static_cast<std::size_t>(std::find(t.begin(), t.end(), c) - t.begin());
  const std::uint32_t a = t[(at_c + 1) % 3], b = t[(at_c + 2) % 3];
  const auto arm = [&](std::uint32_t v) -> Vec3 { return mesh.vertices[v] - centre_; };
  const double gain =
      sixfold(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], mesh.vertices[d]);
  if (gain <= 6.0 * kLeastGain * hull_volume_) return false;
  // Both new triangles have to be seen from the centre, or directions would be covered twice.
  const auto seen = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    const Vec3 u = arm(p), v = arm(q), w = arm(r);
    return u.cross(v).dot(w) > kCoplanarDirections * u.norm() * v.norm() * w.norm();
  };
  if (!seen(c, a, d) || !seen(d, b, c)) return false;
  edge_flips_.push_back({first, second, {c, a, d}, {d, b, c}});
  mesh.triangles[first] = edge_flips_.back().new_first;
  mesh.triangles[second] = edge_flips_.back().new_second;
  return true;
}

void HullInterpolation::find_edge_flips() {
  TriangleMesh mesh = interpolate(1.0, 0);
  for (bool any = true; any;) {
    any = false;
    const std::vector<HalfEdge> sides = sorted_half_edges(mesh);
    std::set<EdgeKey> edges;
    for (const HalfEdge& side : sides) edges.insert({side.low, side.high});
    std::vector<bool> changed(mesh.triangles.size(), false);
    for_each_edge(sides, [&](std::span<const HalfEdge> pair) {
      if (!is_interior_edge(pair)) return;
      const std::uint32_t first = pair[0].triangle, second = pair[1].triangle;
      if (changed[first] || changed[second]) return;
      const EdgeKey edge = {pair[0].low, pair[0].high};
      const EdgeKey other =
          make_edge_key(across(mesh.triangles[first], edge), across(mesh.triangles[second], edge));
      if (edges.contains(other) || !flip_edge(mesh, first, second, edge)) return;
      edges.insert(other);
      changed[first] = changed[second] = any = true;
    });
  }
}

}  // namespace clast
