#include "particles/particle_body.hpp"

#include <utility>

#include "massprops/solid.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

ParticleBody make_particle_body(TriangleMesh mesh) {
  ParticleBody body;
  body.mass = solid_mass_properties(mesh, 1.0);
  body.length = smallest_box(mesh.vertices).lengths[0];
  body.mesh = std::move(mesh);
  return body;
}

ParticleBody make_particle_body(const Block& block) {
  ParticleBody body = make_particle_body(block, core_mesh(block.body));
  body.radius = block.body.radius;
  return body;
}

ParticleBody make_particle_body(const Block& block, const TriangleMesh& surface) {
  ParticleBody body;
  body.mesh = transformed(surface, block.source_from_body().inverse());
  body.mass = block.mass;
  body.mass.centre = Vec3::Zero();
  body.mass.inertia = block.principal.moments.asDiagonal();
  body.length = block.box.lengths[0];
  return body;
}

}  // namespace clast
