#include "shapes/edge_bend.hpp"

#include <algorithm>
#include <span>

#include "shapes/detail/face_sides.hpp"

namespace clast {

EdgeBend edge_bend(const Vec3& first, const Vec3& second, const Vec3& into_second) {
  const double rise = first.dot(into_second);
  if (rise > kFlatSine) return EdgeBend::kReflex;
  if (rise < -kFlatSine || first.dot(second) < 0.0) return EdgeBend::kConvex;
  return EdgeBend::kFlat;
}

std::vector<EdgeBend> edge_bends(const SpheroPolyhedron& shape) {
  std::vector<Vec3> normals;
  normals.reserve(shape.faces.size());
  for (const SpheroPolyhedron::Face& face : shape.faces) {
    normals.push_back(face_normal(shape, face));
  }
  std::vector<EdgeBend> bends(shape.edges.size(), EdgeBend::kConvex);
  const std::vector<shapes_detail::FaceSide> sides = shapes_detail::sorted_face_sides(shape.faces);
  shapes_detail::for_each_shared_edge(sides, [&](std::span<const shapes_detail::FaceSide> shared) {
    if (!shapes_detail::are_neighbours(shared)) return;
    const SpheroPolyhedron::Edge edge = {shared[0].low, shared[0].high};
    const auto place = std::lower_bound(shape.edges.begin(), shape.edges.end(), edge);
    if (place == shape.edges.end() || *place != edge) return;
    const Vec3 along = shape.vertices[shared[1].to()] - shape.vertices[shared[1].from()];
    const Vec3& second = normals[shared[1].face];
    bends[static_cast<std::size_t>(place - shape.edges.begin())] =
        edge_bend(normals[shared[0].face], second, second.cross(along).normalized());
  });
  return bends;
}

}  // namespace clast
