#include "mesh/triangle_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace clast {

Vec3 doubled_area_vector(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  return (mesh.vertices[t[1]] - mesh.vertices[t[0]])
      .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
}

Vec3 unit_normal(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  const Vec3 area = doubled_area_vector(mesh, t);
  const double norm = area.norm();
  return norm > 0.0 ? Vec3(area / norm) : Vec3(Vec3::Zero());
}

Vec3 centroid(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  return (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
}

double corner_angle(const TriangleMesh& mesh, const TriangleMesh::Triangle& t, std::size_t k) {
  const Vec3 a = mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]];
  const Vec3 b = mesh.vertices[t[(k + 2) % 3]] - mesh.vertices[t[k]];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double median_edge_length(const TriangleMesh& mesh) {
  std::vector<double> lengths;
  lengths.reserve(3 * mesh.triangles.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      lengths.push_back((mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]).norm());
    }
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace clast
