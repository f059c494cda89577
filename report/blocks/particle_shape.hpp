#pragma once
/// Surfaces of particles for pictures.
#include <cstdint>
#include <vector>

#include "particles/particle.hpp"

namespace clast::report_detail {

/// Visible surface of a particle.
struct ParticleSurface {
  TriangleMesh mesh;  ///< of spheres: open, as triangles deep inside other spheres are left out
  std::vector<std::uint16_t> components;  ///< sphere or part of each triangle
};

/// Makes the visible surface of a particle in its principal frame. Vertices lie on the spheres;
/// these have fewer triangles the more there are.
ParticleSurface make_particle_surface(const Particle& particle);

}  // namespace clast::report_detail
