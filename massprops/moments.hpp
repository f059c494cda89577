#pragma once
/// Volume, first and second moments of solids, as they add up.
#include "core/types.hpp"
#include "massprops/mass_properties.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::massprops_detail {

/// Integrals of 1, x and x x^T over a solid.
struct Moments {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();

  Moments& operator+=(const Moments& other) {
    volume += other.volume;
    first += other.first;
    second += other.second;
    return *this;
  }
  /// Adds `factor` times the other solid; -1 subtracts it.
  void add_scaled(const Moments& other, double factor) {
    volume += factor * other.volume;
    first += factor * other.first;
    second += factor * other.second;
  }
};

/// Of the signed tetrahedron between the origin and a triangle. @cite mirtich1996
Moments tetrahedron_moments(const Vec3& a, const Vec3& b, const Vec3& c);

/// Sum over the triangles, with vertices relative to `origin`.
Moments polyhedron_moments(const TriangleMesh& mesh, const Vec3& origin);

/// Mean of the vertices that triangles use, summed about the first so that large offsets keep their
/// digits; zero when there is no triangle.
Vec3 vertex_mean(const TriangleMesh& mesh);

/// Moments about `origin`, along axes that `rotation` (source_from_local) turns to the source's.
MassProperties to_mass_properties(const Moments& moments, const Vec3& origin, const Mat3& rotation,
                                  double density);

/// @throws InputError  density not positive or not finite
void check_density(double density);

/// Refuses what bounds no solid. `what` names the mesh in the message.
/// @throws GeometryError  open, non-manifold or inconsistently oriented
void check_closed(const TriangleMesh& mesh, const char* what);

}  // namespace clast::massprops_detail
