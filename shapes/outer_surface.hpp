#pragma once
/// Rounded surface as a mesh without self-intersections.
#include <optional>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Returns the triangle edge length of `outer_surface_mesh` for a body with reflex edges, m: one
/// segment of a quarter turn, but at least 1/150 of the diagonal. Empty for other bodies.
std::optional<double> outer_surface_edge_length(const SpheroPolyhedron& shape, int segments);

/// Returns the number of segments above which `outer_surface_mesh` is not refined further, for a
/// body with reflex edges.
int max_outer_surface_segments(const SpheroPolyhedron& shape);

/// Makes a closed, oriented 2-manifold without self-intersections around the rounded body. Without
/// reflex edges, it is `rounded_surface_mesh`. With reflex edges, the surface is wrapped with
/// triangles of about `outer_surface_edge_length`. Vertices then lie on the rounded surface.
/// Creases are bevelled and clefts closed at that length; the volume error is of second order in
/// it.
/// @param segments  number of segments per quarter turn
/// @throws GeometryError, InputError  as `rounded_surface_mesh`
/// @cite portaneri2022
TriangleMesh outer_surface_mesh(const SpheroPolyhedron& shape, int segments = 4);

}  // namespace clast
