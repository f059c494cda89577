#pragma once
/// Exact volume, centre, inertia tensor and exposed area of unions of balls.
#include <span>
#include <vector>

#include "massprops/mass_properties.hpp"
#include "shapes/inscribed_ball.hpp"

namespace clast {

/// Computes the mass properties of a union of balls, to rounding. Volume shared by several balls
/// counts once. Balls may touch, coincide, be contained in each other or be apart.
///
/// The divergence theorem turns the integrals over the union into integrals over the exposed patch
/// of each sphere. These reduce to its solid angle, from spherical triangles, and to integrals
/// along its boundary arcs, because polynomials on the sphere are eigenfunctions of its Laplacian
/// (docs/theory/particles.md).
/// @param density  kg/m^3, positive
/// @throws InputError  if there is no ball, a radius is not positive, or a value is not finite
MassProperties ball_union_mass_properties(std::span<const Ball> balls, double density);

/// Returns for each sphere the area outside all other balls, m^2. If all radii grow by dr, the
/// volume of the union grows by the sum of these areas times dr.
/// @throws InputError  as `ball_union_mass_properties`
std::vector<double> exposed_areas(std::span<const Ball> balls);

}  // namespace clast
