#include "classify/roundness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "mesh/mesh_topology.hpp"
#include "shapes/inscribed_ball.hpp"

namespace clast {
namespace {

/// Sums over the triangles around a vertex.
struct VertexSum {
  double area = 0.0;             ///< its part of the triangles
  double angle = 0.0;            ///< of all corners at the vertex
  Vec3 normal = Vec3::Zero();    ///< sum of area-weighted face normals
  Vec3 gradient = Vec3::Zero();  ///< of the area of the mesh by the vertex's place
};

double cotangent(const Vec3& a, const Vec3& b) {
  const double cross = a.cross(b).norm();
  return cross > 0.0 ? a.dot(b) / cross : 0.0;
}

/// Voronoi parts of the triangles' area, or halves and quarters where they are obtuse.
std::array<double, 3> corner_areas(const std::array<Vec3, 3>& p, double area) {
  std::array<double, 3> cot{}, parts{};
  for (int i = 0; i < 3; ++i) {
    cot[i] = cotangent(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
    if (cot[i] < 0.0) {
      for (int j = 0; j < 3; ++j) parts[j] = area * (i == j ? 0.5 : 0.25);
      return parts;
    }
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    parts[i] = ((p[j] - p[i]).squaredNorm() * cot[k] + (p[k] - p[i]).squaredNorm() * cot[j]) / 8.0;
  }
  return parts;
}

std::vector<VertexSum> vertex_sums(const TriangleMesh& mesh) {
  std::vector<VertexSum> sums(mesh.vertices.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const std::array<Vec3, 3> p = {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    const Vec3 cross = (p[1] - p[0]).cross(p[2] - p[0]);
    const std::array<double, 3> areas = corner_areas(p, 0.5 * cross.norm());
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
      VertexSum& sum = sums[t[i]];
      sum.area += areas[i];
      sum.angle += std::atan2(a.cross(b).norm(), a.dot(b));
      sum.normal += cross;
      // Each edge is weighed by the cotangent of the angle across from it.
      sum.gradient -= 0.5 * (cotangent(p[i] - p[(i + 2) % 3], -b + a) * a +
                             cotangent(p[i] - p[(i + 1) % 3], -a + b) * b);
    }
  }
  return sums;
}

double largest_curvature(const VertexSum& sum) {
  // The gradient of the area is twice the mean curvature, times the area, along the normal.
  const double mean = sum.gradient.dot(sum.normal.normalized()) / (2.0 * sum.area);
  const double gaussian = (2.0 * kPi - sum.angle) / sum.area;
  return mean + std::sqrt(std::max(0.0, mean * mean - gaussian));
}

double mean_edge_length(const TriangleMesh& mesh) {
  // Counts every edge of a closed mesh twice.
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += (mesh.vertices[b] - mesh.vertices[a]).norm() +
           (mesh.vertices[c] - mesh.vertices[b]).norm() +
           (mesh.vertices[a] - mesh.vertices[c]).norm();
  }
  return sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

}  // namespace

Roundness roundness(const TriangleMesh& mesh) {
  const MeshReport report = inspect_mesh(mesh);
  if (!report.is_closed() || !report.is_oriented()) {
    throw GeometryError("roundness: the surface is not closed: " + report.summary() +
                        "; repair it first");
  }
  Roundness result;
  result.edge_length = mean_edge_length(mesh);
  result.inscribed_radius = largest_inscribed_ball(mesh).radius;
  double corners = 0.0, total = 0.0, weighted = 0.0;
  for (const VertexSum& sum : vertex_sums(mesh)) {
    if (!(sum.area > 0.0)) continue;
    total += sum.area;
    const double sharpness = largest_curvature(sum) * result.inscribed_radius;
    if (!(sharpness > 1.0)) continue;
    corners += sum.area;
    weighted += sum.area / sharpness;
  }
  result.corner_fraction = corners / total;
  if (corners > 0.0) result.value = weighted / corners;
  return result;
}

}  // namespace clast
