#include "mesh/triangle_mesh.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"

namespace clast {

Bounds bounds(const TriangleMesh& mesh) {
  Bounds box;
  for (const Vec3& vertex : mesh.vertices) box.include(vertex);
  return box;
}

double triangle_area(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  return 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                   .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                   .norm();
}

double surface_area(const TriangleMesh& mesh) {
  double doubled = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3 ab = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Vec3 ac = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    doubled += ab.cross(ac).norm();
  }
  return 0.5 * doubled;
}

double signed_volume(const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  const Vec3 origin = 0.5 * (box.low + box.high);
  double sixfold = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    sixfold += (mesh.vertices[t[0]] - origin)
                   .dot((mesh.vertices[t[1]] - origin).cross(mesh.vertices[t[2]] - origin));
  }
  return sixfold / 6.0;
}

TriangleMesh transformed(TriangleMesh mesh, const Pose& to_from) {
  for (Vec3& vertex : mesh.vertices) vertex = to_from * vertex;
  return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) {
    throw InputError("scale factor " + format_significant(factor, 6) +
                     ": must be positive and finite");
  }
  for (Vec3& vertex : mesh.vertices) vertex *= factor;
  return mesh;
}

TriangleMesh merged(TriangleMesh mesh, const TriangleMesh& other) {
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  mesh.triangles.reserve(mesh.triangles.size() + other.triangles.size());
  for (const TriangleMesh::Triangle& t : other.triangles) {
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return mesh;
}

}  // namespace clast
