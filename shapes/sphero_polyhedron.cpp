#include "shapes/sphero_polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace clast {

SpheroPolyhedron sphero_polyhedron(const TriangleMesh& core, double minkowski_radius) {
  if (!(minkowski_radius >= 0.0) || !std::isfinite(minkowski_radius)) {
    throw InputError("Minkowski radius " + std::to_string(minkowski_radius) +
                     " m: must be zero or positive");
  }
  if (core.triangles.empty()) {
    throw GeometryError("a block needs a core with triangles, this mesh has none");
  }
  SpheroPolyhedron shape;
  shape.vertices = core.vertices;
  shape.radius = minkowski_radius;
  shape.edges.reserve(3 * core.triangles.size());
  shape.faces.reserve(core.triangles.size());
  for (const TriangleMesh::Triangle& t : core.triangles) {
    shape.faces.emplace_back(t.begin(), t.end());
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k], to = t[(k + 1) % 3];
      shape.edges.push_back({std::min(from, to), std::max(from, to)});
    }
  }
  std::sort(shape.edges.begin(), shape.edges.end());
  shape.edges.erase(std::unique(shape.edges.begin(), shape.edges.end()), shape.edges.end());
  return shape;
}

TriangleMesh core_mesh(const SpheroPolyhedron& shape) {
  TriangleMesh mesh;
  mesh.vertices = shape.vertices;
  for (const SpheroPolyhedron::Face& face : shape.faces) {
    for (std::size_t k = 2; k < face.size(); ++k) {
      mesh.triangles.push_back({face[0], face[k - 1], face[k]});
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
    throw InputError("scale factor " + std::to_string(factor) + ": must be positive and finite");
  }
  for (Vec3& vertex : shape.vertices) vertex *= factor;
  shape.radius *= factor;
  return shape;
}

}  // namespace clast
