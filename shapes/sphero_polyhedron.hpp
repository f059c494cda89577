#pragma once
/// A polyhedron Minkowski-summed with a sphere: the shape blocks have in contact.
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Core polyhedron (convex or not) and the radius of the sphere swept over it. The body is every
/// point within `radius` of the solid core. One vertex alone is a ball, two and an edge a capsule.
struct SpheroPolyhedron {
  using Edge = std::array<std::uint32_t, 2>;
  using Face = std::vector<std::uint32_t>;  ///< polygon, counter-clockwise seen from outside

  std::vector<Vec3> vertices;  ///< core, m
  std::vector<Edge> edges;     ///< each once, smaller index first, sorted
  std::vector<Face> faces;     ///< planar polygons, concave ones too; triangles unless merged
  double radius = 0.0;         ///< Minkowski radius, m
};

/// The core taken as it is, triangle by triangle, with a radius.
/// @throws GeometryError  the mesh is empty; InputError  radius negative or not finite
SpheroPolyhedron make_sphero_polyhedron(const TriangleMesh& core, double minkowski_radius);

/// The sides of the faces, as `SpheroPolyhedron::edges` holds them.
std::vector<SpheroPolyhedron::Edge> face_edges(const std::vector<SpheroPolyhedron::Face>& faces);

/// Twice the area of a face, along its normal.
Vec3 area_vector(const SpheroPolyhedron& shape, const SpheroPolyhedron::Face& face);
/// Unit, out of the solid.
Vec3 face_normal(const SpheroPolyhedron& shape, const SpheroPolyhedron::Face& face);

/// The core as triangles, face by face, two fewer than a face has corners. Polygons are cut along
/// diagonals inside them, and into triangles that have area where that can be had.
TriangleMesh core_mesh(const SpheroPolyhedron& shape);

/// The rounded surface as a closed triangle mesh whose vertices lie on it: core faces moved out,
/// cylinders over convex edges, sphere patches over vertices. `segments` pieces per quarter turn.
/// At reflex edges the pieces cross inside the body: the mesh goes round every point of the body
/// and round no other, but round some twice, so it is no measure of volume there;
/// `outer_surface_mesh` is.
/// @throws GeometryError  the core is not closed (nor a lone vertex or edge with a radius)
TriangleMesh rounded_surface_mesh(const SpheroPolyhedron& shape, int segments = 4);

/// The same body at another place.
SpheroPolyhedron transformed(SpheroPolyhedron shape, const Pose& to_from);
/// Core and radius scaled about the origin.
SpheroPolyhedron scaled(SpheroPolyhedron shape, double factor);

}  // namespace clast
