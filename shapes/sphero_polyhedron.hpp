#pragma once
/// A polyhedron Minkowski-summed with a sphere: the shape blocks have in contact.
#include <array>
#include <cstdint>
#include <vector>

#include "shapes/triangle_mesh.hpp"

namespace clast {

/// Core polyhedron (convex or not) and the radius of the sphere swept over it. The body is every
/// point within `radius` of the solid core. One vertex alone is a ball, two and an edge a capsule.
struct SpheroPolyhedron {
  using Edge = std::array<std::uint32_t, 2>;
  using Face = std::vector<std::uint32_t>;  ///< polygon, counter-clockwise seen from outside

  std::vector<Vec3> vertices;  ///< core, m
  std::vector<Edge> edges;     ///< each once, smaller index first, sorted
  std::vector<Face> faces;     ///< planar polygons; triangles unless merged
  double radius = 0.0;         ///< Minkowski radius, m
};

/// The core taken as it is, triangle by triangle, with a radius.
/// @throws GeometryError  the mesh is empty; InputError  radius negative or not finite
SpheroPolyhedron sphero_polyhedron(const TriangleMesh& core, double minkowski_radius);

/// The core as triangles (polygons cut into fans).
TriangleMesh core_mesh(const SpheroPolyhedron& shape);

/// The rounded surface as a closed triangle mesh whose vertices lie on it: core faces moved out,
/// cylinders over convex edges, sphere patches over vertices. `segments` pieces per quarter turn.
/// At reflex edges the pieces cross; the mesh is for viewing and export, not for volumes.
/// @throws GeometryError  the core is not closed (nor a lone vertex or edge with a radius)
TriangleMesh skin_mesh(const SpheroPolyhedron& shape, int segments = 4);

/// The same body at another place.
SpheroPolyhedron transformed(SpheroPolyhedron shape, const Pose& to_from);
/// Core and radius scaled about the origin.
SpheroPolyhedron scaled(SpheroPolyhedron shape, double factor);

}  // namespace clast
