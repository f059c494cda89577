#include "shapes/sphero_polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/half_edges.hpp"
#include "mesh/polygon.hpp"

namespace clast {

SpheroPolyhedron make_sphero_polyhedron(const TriangleMesh& core, double minkowski_radius) {
  if (!(minkowski_radius >= 0.0) || !std::isfinite(minkowski_radius)) {
    throw InputError("Minkowski radius " + format_significant(minkowski_radius, 6) +
                     " m: must be zero or positive");
  }
  if (core.triangles.empty()) {
    throw GeometryError("a block needs a core with triangles, but this mesh has none");
  }
  SpheroPolyhedron shape;
  shape.vertices = core.vertices;
  shape.radius = minkowski_radius;
  shape.faces.reserve(core.triangles.size());
  for (const TriangleMesh::Triangle& t : core.triangles) {
    shape.faces.emplace_back(t.begin(), t.end());
  }
  shape.edges = face_edges(shape.faces);
  return shape;
}

std::vector<SpheroPolyhedron::Edge> face_edges(const std::vector<SpheroPolyhedron::Face>& faces) {
  std::vector<SpheroPolyhedron::Edge> edges;
  for_each_edge(sorted_half_edges(faces), [&](std::span<const HalfEdge> sides) {
    if (sides[0].low != sides[0].high) edges.push_back({sides[0].low, sides[0].high});
  });
  return edges;
}

Vec3 doubled_face_area_vector(const SpheroPolyhedron& shape, const SpheroPolyhedron::Face& face) {
  Vec3 area = Vec3::Zero();
  const Vec3& origin = shape.vertices[face[0]];
  for (std::size_t k = 2; k < face.size(); ++k) {
    area += (shape.vertices[face[k - 1]] - origin).cross(shape.vertices[face[k]] - origin);
  }
  return area;
}

Vec3 face_normal(const SpheroPolyhedron& shape, const SpheroPolyhedron::Face& face) {
  return doubled_face_area_vector(shape, face).normalized();
}

TriangleMesh core_mesh(const SpheroPolyhedron& shape) {
  TriangleMesh mesh;
  mesh.vertices = shape.vertices;
  for (const SpheroPolyhedron::Face& face : shape.faces) {
    if (face.size() == 3) {
      mesh.triangles.push_back({face[0], face[1], face[2]});
    } else {
      const std::vector<std::int64_t> corners(face.begin(), face.end());
      append_polygon(mesh, corners);
    }
  }
  return mesh;
}

SpheroPolyhedron transformed(SpheroPolyhedron shape, const Pose& to_from) {
  for (Vec3& vertex : shape.vertices) vertex = to_from * vertex;
  return shape;
}

SpheroPolyhedron scaled(SpheroPolyhedron shape, double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) {
    throw InputError("scale factor " + format_significant(factor, 6) +
                     ": must be positive and finite");
  }
  for (Vec3& vertex : shape.vertices) vertex *= factor;
  shape.radius *= factor;
  return shape;
}

}  // namespace clast
