#pragma once
/// Rounded surface as a mesh without self-intersections.
#include <optional>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Returns the edge length with which `outer_surface_mesh` wraps bodies with reflex edges, m: one
/// segment of a quarter turn, at least 1/150 of the diagonal. Empty for bodies that need no
/// wrapping.
std::optional<double> wrap_edge_length(const SpheroPolyhedron& shape, int segments);

/// Returns the largest number of segments that still refines a wrapped body.
int max_wrap_segments(const SpheroPolyhedron& shape);

/// Makes a closed, oriented 2-manifold without self-intersections around the rounded body. Without
/// reflex edges this is `rounded_surface_mesh`. Otherwise the offset of the core is wrapped:
/// vertices lie on the rounded surface, with triangles of about `wrap_edge_length`; creases are
/// bevelled and clefts closed at that size, with a volume error of second order in it.
/// @param segments  per quarter turn
/// @throws GeometryError, InputError  as `rounded_surface_mesh`
/// @cite portaneri2022
TriangleMesh outer_surface_mesh(const SpheroPolyhedron& shape, int segments = 4);

}  // namespace clast
