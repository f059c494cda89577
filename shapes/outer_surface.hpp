#pragma once
/// The rounded surface as one clean mesh, whatever the core is like.
#include <optional>

#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Length of the triangles that `outer_surface_mesh` wraps a body with a reflex edge in, m: a piece
/// of a quarter turn, but no shorter than 1/150 of the diagonal. None where nothing is wrapped, so
/// that each of the pieces is there.
std::optional<double> wrap_edge_length(const SpheroPolyhedron& shape, int segments);

/// The largest number of pieces that still changes the skin of a body that is wrapped.
int max_wrap_segments(const SpheroPolyhedron& shape);

/// A closed, oriented 2-manifold without crossings around the rounded body. Where no edge is
/// reflex this is `rounded_surface_mesh`. Else the offset of the core is wrapped: vertices lie on
/// the rounded surface, triangles are about `wrap_edge_length` long, so that creases are bevelled
/// at that size, and the volume is short by a share of its square; clefts narrower than it are
/// closed.
/// @param segments  pieces per quarter turn
/// @throws GeometryError, InputError  as `rounded_surface_mesh`
/// @cite portaneri2022
TriangleMesh outer_surface_mesh(const SpheroPolyhedron& shape, int segments = 4);

}  // namespace clast
