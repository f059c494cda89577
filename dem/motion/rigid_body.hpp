#pragma once
/// Rigid body: contact shape, inertia and state.
#include <memory>
#include <string>
#include <vector>

#include "massprops/mass_properties.hpp"
#include "shapes/sphero_polyhedron.hpp"

namespace clast {

/// State of a rigid body: position of the centre of mass, orientation of the principal frame, and
/// velocities, in the world frame.
struct RigidState {
  Vec3 position = Vec3::Zero();          ///< position of the centre of mass, m
  Quat orientation = Quat::Identity();   ///< orientation of the principal frame, world_from_body
  Vec3 velocity = Vec3::Zero();          ///< velocity of the centre of mass, m/s
  Vec3 angular_velocity = Vec3::Zero();  ///< angular velocity, rad/s, world axes

  Pose world_from_body() const { return {position, orientation}; }
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(position, orientation, velocity, angular_velocity);
  }
};

/// Rigid body in its principal frame, with its origin at the centre of mass.
struct RigidBody {
  SpheroPolyhedron shape;       ///< contact shape in the body frame
  double mass = 0.0;            ///< kg
  Vec3 moments = Vec3::Zero();  ///< principal moments of inertia, along the body axes, kg m^2
  /// Shortest side S of the smallest box, m; the tolerances are proportional to it.
  double smallest_side = 0.0;

  /// Returns the radius of the sphere about the centre of mass that contains the rounded body, m.
  double bounding_radius() const;
  double size() const;  ///< `smallest_side`, or the diameter if that is not set, m
  /// @param name  name of the body in the message
  /// @throws SimulationError  if mass or moments are not positive, or the shape has no vertices
  void check(const std::string& name) const;
};

/// Returns the kinetic energy of the translation, J.
double translational_energy(const RigidBody& body, const RigidState& state);
double rotational_energy(const RigidBody& body, const RigidState& state);

/// Returns the lowest z coordinate of any surface point of the body, m.
double lowest_height(const RigidBody& body, const RigidState& state);

/// Returns the state after a free flight, in closed form: ballistic centre of mass, torque-free
/// rotation. Angular momentum is conserved to rounding.
RigidState free_flight(const RigidBody& body, const RigidState& state, double duration,
                       double gravity);

}  // namespace clast
