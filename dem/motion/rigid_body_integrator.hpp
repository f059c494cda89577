#pragma once
/// Velocity Verlet integration of a rigid body, with the angular momentum as rotational state.
#include "dem/motion/body_motion.hpp"
#include "dem/motion/rigid_body.hpp"

namespace clast::dem_detail {

/// Integrates the motion of a rigid body. `begin_step` and `end_step` alternate; contacts are
/// evaluated between them.
class RigidBodyIntegrator {
 public:
  RigidBodyIntegrator(const RigidBody& body, const RigidState& start);

  const RigidState& state() const { return state_; }
  void set_state(const RigidState& state);

  BodyMotion advance_flight(double duration, const Vec3& gravity);
  /// Applies the first half of the velocity update and moves the body.
  /// @return motion over the step: new pose and mean velocities
  BodyMotion begin_step(double duration, const Vec3& force, const Vec3& torque,
                        const Vec3& gravity);
  /// Applies the second half of the velocity update, with the loads at the new pose.
  void end_step(double duration, const Vec3& force, const Vec3& torque, const Vec3& gravity);

  /// Corrects motion and pose after a step in which contacts began, reversed or ended.
  /// @param impulse, angular_impulse  added momentum, N s, and angular momentum, N m s
  /// @param moment, angular_moment  mass times displacement, N s^2; inertia times rotation, N m s^2
  /// @return the added kinetic and potential energy, J
  double apply_correction_impulse(const Vec3& impulse, const Vec3& angular_impulse,
                                  const Vec3& moment, const Vec3& angular_moment,
                                  const Vec3& gravity);

  /// Returns the energy that velocity Verlet steps lose at the start of a motion, J. The loss
  /// occurs because the first load is not the result of a step (docs/theory.md).
  double verlet_start_loss(double duration, const Vec3& force, const Vec3& torque,
                           const Vec3& gravity) const;

  /// Returns the present pose and velocities as a motion of zero duration.
  BodyMotion current_motion() const;
  double kinetic_energy() const;  ///< J
  /// Returns an upper bound of the angular speed while no torque acts, rad/s.
  double max_angular_speed() const;
  /// Returns an upper bound of the speed of any body point in the last step, m/s.
  double max_point_speed() const { return max_point_speed_; }
  /// Returns an upper bound of how far the last `apply_correction_impulse` moved any body point, m.
  double correction_displacement() const { return correction_displacement_; }
  bool is_finite() const;
  template <class Bytes>
  void serialize(Bytes& bytes) {
    bytes(state_, momentum_, max_point_speed_, correction_displacement_);
  }

 private:
  const RigidBody& body_;
  RigidState state_;
  Vec3 momentum_;  ///< angular momentum, world axes, kg m^2/s
  double radius_;  ///< radius of the rounded body about its centre, m
  double smallest_moment_;
  double max_point_speed_ = 0.0;
  double correction_displacement_ = 0.0;
};

}  // namespace clast::dem_detail
