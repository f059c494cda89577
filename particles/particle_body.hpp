#pragma once
/// Body for which a simpler shape is made.
#include "library/block.hpp"
#include "massprops/mass_properties.hpp"
#include "mesh/triangle_mesh.hpp"

namespace clast {

/// Body for which a simpler shape is made.
struct ParticleBody {
  TriangleMesh mesh;    ///< closed, outward, m
  double radius = 0.0;  ///< the body is all points within this distance of the solid of `mesh`, m
  MassProperties mass;  ///< of the true body, in the frame of the mesh
  double length = 0.0;  ///< longest side L of the smallest box, m
};

/// Makes a body from a closed mesh, with the mass properties of its solid at 1 kg/m^3.
/// @throws GeometryError  if the mesh is open or its signed volume is not positive
ParticleBody make_particle_body(TriangleMesh mesh);

/// Makes a body from a block, in its principal frame: core and radius, and the stored mass
/// properties.
ParticleBody make_particle_body(const Block& block);

/// Makes a body from a block, in its principal frame, with another surface and the stored mass
/// properties.
/// @param surface  closed, outward, in the frame of the scan
ParticleBody make_particle_body(const Block& block, const TriangleMesh& surface);

}  // namespace clast
