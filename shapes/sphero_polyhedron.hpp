#pragma once
/// Sphero-polyhedron: Minkowski sum of a polyhedron and a ball. It is the contact shape of blocks.
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Sphero-polyhedron with any core, convex or not. The body is the set of points within `radius` of
/// the solid core. A single vertex is a ball; two vertices and an edge are a capsule.
struct SpheroPolyhedron {
  using Edge = std::array<std::uint32_t, 2>;
  using Face = std::vector<std::uint32_t>;  ///< polygon, counter-clockwise seen from outside

  std::vector<Vec3> vertices;  ///< vertices of the core, m
  std::vector<Edge> edges;     ///< each once, with the smaller index first; sorted
  std::vector<Face> faces;     ///< planar polygons, which may be concave; triangles unless merged
  double radius = 0.0;         ///< Minkowski radius, m
};

/// Makes a sphero-polyhedron from a core mesh, with its triangles as faces.
/// @throws GeometryError  if the mesh is empty
/// @throws InputError  if the radius is negative or not finite
SpheroPolyhedron make_sphero_polyhedron(const TriangleMesh& core, double minkowski_radius);

/// Returns the edges of the faces, in the form of `SpheroPolyhedron::edges`.
std::vector<SpheroPolyhedron::Edge> face_edges(const std::vector<SpheroPolyhedron::Face>& faces);

/// Returns the normal of a face, with the length of twice its area.
Vec3 doubled_face_area_vector(const SpheroPolyhedron& shape, const SpheroPolyhedron::Face& face);
/// Returns the outward unit normal of a face.
Vec3 face_normal(const SpheroPolyhedron& shape, const SpheroPolyhedron::Face& face);

/// Triangulates the core face by face, along inner diagonals. A face with n vertices gives n - 2
/// triangles. Degenerate triangles are avoided.
TriangleMesh core_mesh(const SpheroPolyhedron& shape);

/// Makes the rounded surface as a closed mesh. It consists of offset core faces, cylinders over
/// convex edges, and spherical patches over vertices. All vertices lie on the rounded surface. At
/// reflex edges, the parts intersect inside the body, so that the volume is not valid
/// (`outer_surface_mesh`).
/// @param segments  number of segments per quarter turn
/// @throws GeometryError  if the core is not closed; a single vertex or edge with a radius is
///                        accepted
TriangleMesh rounded_surface_mesh(const SpheroPolyhedron& shape, int segments = 4);

SpheroPolyhedron transformed(SpheroPolyhedron shape, const Pose& to_from);
/// Returns the body with core and radius scaled about the origin.
SpheroPolyhedron scaled(SpheroPolyhedron shape, double factor);

}  // namespace clast
