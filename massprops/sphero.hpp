#pragma once
/// Mass properties of sphero-polyhedra.
#include "massprops/mass_properties.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Closed form for a convex core: polyhedron, face prisms, edge wedges and vertex cones.
/// @throws GeometryError  core open, not outward, or with a reflex edge (beyond 1e-9 rad)
MassProperties convex_sphero_mass_properties(const SpheroPolyhedron& body, double density);

/// For any core, convex or not, also one that touches or crosses itself: closed form when convex,
/// else columns along z over which the body is a union of intervals that are integrated exactly,
/// refined until two successive grids agree within `accuracy`.
/// @param accuracy  relative, on volume and inertia; the reached bound is in `relative_error`
/// @throws GeometryError  core open or its volume not positive
MassProperties sphero_mass_properties(const SpheroPolyhedron& body, double density,
                                      double accuracy = 1e-4);

}  // namespace clast
