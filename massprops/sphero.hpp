#pragma once
/// Mass properties of sphero-polyhedra.
#include "massprops/mass_properties.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// Computes the mass properties of a rounded convex core in closed form. They are the sums over
/// polyhedron, face prisms, edge wedges and vertex cones. A core may be a single vertex (ball) or
/// two vertices (capsule).
/// @throws GeometryError  if the core is open, oriented inward or has an edge that is reflex by
///                        more than 1e-9 rad
MassProperties convex_sphero_mass_properties(const SpheroPolyhedron& body, double density);

/// Computes the mass properties of any rounded core, also with self-contacts. The closed form for
/// convex cores counts some volume more than once near reflex edges and self-contacts. This volume
/// is integrated along columns and subtracted. The columns are refined until four interleaved grids
/// of half the density agree within `accuracy`. Convex bodies are exact.
/// @param accuracy  relative to the volume and, for the inertia tensor, to the smallest principal
///                  moment; in [1e-9, 0.1]. `relative_error` is the largest deviation of the four
///                  grids from their mean. It can exceed `accuracy` only if the surface intersects
///                  itself at a scale below 1/4096 of the body.
/// @throws GeometryError  if the core is open or its volume is not positive
/// @throws InputError     if the accuracy is out of range
MassProperties sphero_mass_properties(const SpheroPolyhedron& body, double density,
                                      double accuracy = 1e-4);

/// Returns the surface area of the rounded body, m^2: the derivative of its volume with respect to
/// the radius. It is exact for convex cores, otherwise accurate to about 1e-3.
/// @throws GeometryError  if the core is open or its volume is not positive
double sphero_surface_area(const SpheroPolyhedron& body);

}  // namespace clast
