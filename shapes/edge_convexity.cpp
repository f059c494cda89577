#include "shapes/edge_convexity.hpp"

#include <algorithm>
#include <span>

#include "mesh/half_edges.hpp"

namespace clast {

EdgeConvexity edge_convexity(const Vec3& first, const Vec3& second, const Vec3& into_second) {
  const double rise = first.dot(into_second);
  if (rise > kFlatSine) return EdgeConvexity::kReflex;
  if (rise < -kFlatSine || first.dot(second) < 0.0) return EdgeConvexity::kConvex;
  return EdgeConvexity::kFlat;
}

std::vector<EdgeConvexity> edge_convexities(const SpheroPolyhedron& shape) {
  std::vector<Vec3> normals;
  normals.reserve(shape.faces.size());
  for (const SpheroPolyhedron::Face& face : shape.faces) {
    normals.push_back(face_normal(shape, face));
  }
  std::vector<EdgeConvexity> bends(shape.edges.size(), EdgeConvexity::kConvex);
  const std::vector<HalfEdge> sides = sorted_half_edges(shape.faces);
  for_each_edge(sides, [&](std::span<const HalfEdge> shared) {
    if (!is_interior_edge(shared)) return;
    const SpheroPolyhedron::Edge edge = {shared[0].low, shared[0].high};
    const auto place = std::lower_bound(shape.edges.begin(), shape.edges.end(), edge);
    if (place == shape.edges.end() || *place != edge) return;
    const Vec3 along = shape.vertices[shared[1].to()] - shape.vertices[shared[1].from()];
    const Vec3& second = normals[shared[1].triangle];
    bends[static_cast<std::size_t>(place - shape.edges.begin())] =
        edge_convexity(normals[shared[0].triangle], second, second.cross(along).normalized());
  });
  return bends;
}

}  // namespace clast
