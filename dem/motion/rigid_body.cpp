#include "dem/motion/rigid_body.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "dem/motion/free_flight.hpp"
#include "dem/motion/rotation.hpp"

namespace clast {

using namespace dem_detail;

double RigidBody::bounding_radius() const {
  double largest = 0.0;
  for (const Vec3& vertex : shape.vertices) largest = std::max(largest, vertex.norm());
  return largest + shape.radius;
}

double RigidBody::size() const {
  return smallest_side > 0.0 ? smallest_side : 2.0 * bounding_radius();
}

void RigidBody::check(const std::string& name) const {
  if (!(mass > 0.0) || !(moments.minCoeff() > 0.0) || shape.vertices.empty()) {
    throw SimulationError(name +
                          ": mass and principal moments must be positive and the shape must have a "
                          "vertex");
  }
}

double translational_energy(const RigidBody& body, const RigidState& state) {
  return 0.5 * body.mass * state.velocity.squaredNorm();
}

double rotational_energy(const RigidBody& body, const RigidState& state) {
  const Vec3 spin = rotated(state.orientation.conjugate(), state.angular_velocity);
  return 0.5 * spin.dot(body.moments.cwiseProduct(spin));
}

double lowest_height(const RigidBody& body, const RigidState& state) {
  const Vec3 down_row = state.orientation.toRotationMatrix().row(2);
  double lowest = 1e300;
  for (const Vec3& vertex : body.shape.vertices) lowest = std::min(lowest, down_row.dot(vertex));
  return state.position.z() + lowest - body.shape.radius;
}

RigidState free_flight(const RigidBody& body, const RigidState& state, double duration,
                       double gravity) {
  return FreeFlight(body, state, gravity).state_after(duration);
}

}  // namespace clast
