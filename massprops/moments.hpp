#pragma once
/// Volume and first and second moments of solids.
#include "core/types.hpp"
#include "massprops/mass_properties.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast::massprops_detail {

/// Integrals of 1, x and x x^T over a solid.
struct SolidMoments {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();

  SolidMoments& operator+=(const SolidMoments& other) {
    volume += other.volume;
    first += other.first;
    second += other.second;
    return *this;
  }
  /// Adds `factor` times the moments of another solid.
  void add_scaled(const SolidMoments& other, double factor) {
    volume += factor * other.volume;
    first += factor * other.first;
    second += factor * other.second;
  }
};

/// Returns the moments of the signed tetrahedron of the origin and a triangle. @cite mirtich1996
SolidMoments tetrahedron_moments(const Vec3& a, const Vec3& b, const Vec3& c);

/// Returns the moments of a closed mesh about `origin`.
SolidMoments polyhedron_moments(const TriangleMesh& mesh, const Vec3& origin);

/// Returns the mean of the used vertices; zero if there are no triangles.
Vec3 vertex_mean(const TriangleMesh& mesh);

/// Converts moments about `origin` along local axes to mass properties in the source frame.
/// @param rotation  source_from_local
MassProperties to_mass_properties(const SolidMoments& moments, const Vec3& origin,
                                  const Mat3& rotation, double density);

/// Checks a density.
/// @throws InputError  if it is not positive and finite
void check_density(double density);

/// Checks that a mesh bounds a solid.
/// @param what  name of the mesh in the message
/// @throws GeometryError  if it is open, non-manifold or inconsistently oriented
void check_closed(const TriangleMesh& mesh, const char* what);

}  // namespace clast::massprops_detail
