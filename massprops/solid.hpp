#pragma once
/// Exact mass properties of the solid inside a closed mesh.
#include "massprops/mass_properties.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Exact integrals over the solid bounded by `mesh`, by the divergence theorem about a local
/// origin, so that coordinates of 5e6 m cost no digits.
///
/// @param mesh     closed, outward-facing triangles; vertices in metres
/// @param density  kg/m^3, positive
/// @throws GeometryError  mesh open or non-manifold, or its signed volume is not positive
/// @cite mirtich1996
MassProperties solid_mass_properties(const TriangleMesh& mesh, double density);

}  // namespace clast
