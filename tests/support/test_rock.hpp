#pragma once
/// A concave rock as a body.
#include "massprops/principal_frame.hpp"
#include "massprops/sphero.hpp"
#include "tests/support/rock_mesh.hpp"
#include "tests/support/test_bodies.hpp"

namespace clast {

/// A shape as a body in its principal frame.
inline RigidBody body_of(const SpheroPolyhedron& shape, double density, double smallest_side) {
  const MassProperties mass = sphero_mass_properties(shape, density, 1e-3);
  const PrincipalFrame frame = principal_frame(mass);
  RigidBody body;
  body.shape = transformed(shape, Pose{mass.centre, frame.rotation}.inverse());
  body.mass = mass.mass;
  body.moments = frame.moments;
  body.smallest_side = smallest_side;
  return body;
}

inline RigidBody rock(int frequency, const Vec3& half_axes, double radius, double density,
                      std::uint64_t seed) {
  return body_of(make_sphero_polyhedron(rock_mesh(frequency, half_axes, seed), radius), density,
                 2.0 * half_axes.minCoeff());
}

}  // namespace clast
