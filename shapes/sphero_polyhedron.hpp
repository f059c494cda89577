#pragma once
/// Sphero-polyhedron: Minkowski sum of a polyhedron and a ball, the contact shape of blocks.
#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Core polyhedron (convex or not) and radius of the swept sphere. The body is the set of points
/// within `radius` of the solid core. A single vertex is a ball, two vertices and an edge a
/// capsule.
struct SpheroPolyhedron {
  using Edge = std::array<std::uint32_t, 2>;
  using Face = std::vector<std::uint32_t>;  ///< polygon, counter-clockwise seen from outside

  std::vector<Vec3> vertices;  ///< core, m
  std::vector<Edge> edges;     ///< each once, smaller index first, sorted
  std::vector<Face> faces;     ///< planar polygons, concave ones too; triangles unless merged
  double radius = 0.0;         ///< Minkowski radius, m
};

/// Makes a sphero-polyhedron from a core mesh, with its triangles as faces.
/// @throws GeometryError  if the mesh is empty; InputError if the radius is negative or not finite
SpheroPolyhedron make_sphero_polyhedron(const TriangleMesh& core, double minkowski_radius);

/// Returns the edges of the faces, as stored in `SpheroPolyhedron::edges`.
std::vector<SpheroPolyhedron::Edge> face_edges(const std::vector<SpheroPolyhedron::Face>& faces);

/// Returns the face normal with the length of twice the area.
Vec3 doubled_face_area_vector(const SpheroPolyhedron& shape, const SpheroPolyhedron::Face& face);
/// Returns the outward unit normal of a face.
Vec3 face_normal(const SpheroPolyhedron& shape, const SpheroPolyhedron::Face& face);

/// Triangulates the core face by face, with n - 2 triangles for n vertices, along inner diagonals
/// and avoiding degenerate triangles.
TriangleMesh core_mesh(const SpheroPolyhedron& shape);

/// Makes the rounded surface as a closed mesh with vertices on it: core faces moved outwards,
/// cylinders over convex edges, spherical patches over vertices, with `segments` per quarter turn.
/// At reflex edges the pieces intersect inside the body, so that some points are enclosed twice and
/// the volume is not valid; see `outer_surface_mesh`.
/// @throws GeometryError  if the core is not closed (other than a lone vertex or edge with a
///                        radius)
TriangleMesh rounded_surface_mesh(const SpheroPolyhedron& shape, int segments = 4);

SpheroPolyhedron transformed(SpheroPolyhedron shape, const Pose& to_from);
/// Returns the body scaled about the origin.
SpheroPolyhedron scaled(SpheroPolyhedron shape, double factor);

}  // namespace clast
