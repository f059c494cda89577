#include "massprops/moments.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "mesh/mesh_topology.hpp"

namespace clast::massprops_detail {

SolidMoments tetrahedron_moments(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double six_volumes = a.dot(b.cross(c));
  const Vec3 sum = a + b + c;
  SolidMoments result;
  result.volume = six_volumes / 6.0;
  result.first = (six_volumes / 24.0) * sum;
  result.second = (six_volumes / 120.0) * (a * a.transpose() + b * b.transpose() +
                                           c * c.transpose() + sum * sum.transpose());
  return result;
}

SolidMoments polyhedron_moments(const TriangleMesh& mesh, const Vec3& origin) {
  SolidMoments sum;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += tetrahedron_moments(mesh.vertices[a] - origin, mesh.vertices[b] - origin,
                               mesh.vertices[c] - origin);
  }
  return sum;
}

Vec3 vertex_mean(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return Vec3::Zero();
  const Vec3& first = mesh.vertices[mesh.triangles.front()[0]];
  Vec3 sum = Vec3::Zero();
  for (const auto& triangle : mesh.triangles) {
    for (const auto corner : triangle) sum += mesh.vertices[corner] - first;
  }
  return first + sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

MassProperties to_mass_properties(const SolidMoments& moments, const Vec3& origin,
                                  const Mat3& rotation, double density) {
  const Vec3 centre = moments.first / moments.volume;
  const Mat3 central = moments.second - moments.volume * centre * centre.transpose();
  const Mat3 turned = rotation * central * rotation.transpose();
  MassProperties result;
  result.volume = moments.volume;
  result.mass = density * moments.volume;
  result.centre = origin + rotation * centre;
  const Mat3 inertia = density * (turned.trace() * Mat3::Identity() - turned);
  result.inertia = 0.5 * (inertia + inertia.transpose());
  return result;
}

void check_density(double density) {
  if (!(density > 0.0) || !std::isfinite(density)) {
    throw InputError("density " + format_significant(density, 6) +
                     " kg/m3: must be positive and finite; rock is about 2650");
  }
}

void check_closed(const TriangleMesh& mesh, const char* what) {
  const MeshReport report = inspect_mesh(mesh);
  if (report.is_closed() && report.is_oriented()) return;
  throw GeometryError(std::string(what) + " bounds no solid: " + report.summary() +
                      "; it has no defined volume, repair it first");
}

}  // namespace clast::massprops_detail
