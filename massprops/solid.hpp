#pragma once
/// Mass properties of the solid bounded by a closed mesh.
#include "massprops/mass_properties.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Computes the exact mass properties of the solid bounded by `mesh`, by the divergence theorem. A
/// local origin keeps full precision for map coordinates of 5e6 m.
/// @param mesh     closed, with outward orientation; vertices in m
/// @param density  kg/m^3, positive
/// @throws GeometryError  if the mesh is open or non-manifold, or its signed volume is not positive
/// @cite mirtich1996
MassProperties solid_mass_properties(const TriangleMesh& mesh, double density);

}  // namespace clast
